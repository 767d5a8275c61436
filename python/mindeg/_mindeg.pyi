from typing import Any

# The package's own stub describes what this module gives.
def __getattr__(name: str) -> Any: ...
