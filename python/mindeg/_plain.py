"""Numbers and arrays of numpy as Python's own, which JSON takes."""

import math
from collections.abc import Mapping


def _native(value):
    """A number of numpy's as Python's own."""
    if type(value) in (int, float, str, bool):
        return value
    import numpy as np

    if isinstance(value, (np.ndarray, np.generic)) and np.ndim(value) == 0 and value is not np.ma.masked:
        return float(value) if isinstance(value.item(), np.generic) else value.item()
    return value


def number(value, key):
    """A finite number; a fault names its key."""
    value = _native(value)
    if isinstance(value, int) and not isinstance(value, bool) or isinstance(value, float) and math.isfinite(value):
        return value
    raise ValueError(f"{key} is {value!r}; give a finite number")


def whole_number(value, key):
    """A whole number of any type; a fault names its key."""
    value = _native(value)
    if isinstance(value, (int, float)) and not isinstance(value, bool) and value % 1 == 0:
        return int(value)
    raise ValueError(f"{key} is {value!r}; give a whole number")


def plain(value, key="value"):
    """What a dict holds as JSON has it. Numbers that JSON has not are refused by their key."""
    value = _native(value)
    if value is None or isinstance(value, (str, bool)):
        return value
    if isinstance(value, (int, float)):
        return number(value, key)
    if isinstance(value, Mapping):
        return {name: plain(inner, f"{key}.{name}".lstrip(".")) for name, inner in value.items()}
    import numpy as np

    if isinstance(value, np.ndarray) and np.ma.is_masked(value):
        raise ValueError(f"{key} has masked values; give finite numbers")
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(inner, f"{key}[{index}]") for index, inner in enumerate(value)]
    raise TypeError(f"{key} is of the type {type(value).__name__}; a domain holds numbers, texts, lists and dicts")
