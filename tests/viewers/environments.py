"""Makes the viewers' environments: one folder each, of pinned packages, made once.

An environment remembers the pins that it was made from. While they are unchanged it is
used as it stands; otherwise it is thrown away and made again.
"""

import ctypes
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent

# What the viewers load from the system, and the Debian package that brings it. None of it
# needs a display; a bare image simply lacks it.
SYSTEM_LIBRARIES = {
    "libGL.so.1": "libgl1",
    "libOpenGL.so.0": "libopengl0",
    "libX11.so.6": "libx11-6",
    "libxcb.so.1": "libxcb1",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libICE.so.6": "libice6",
    "libSM.so.6": "libsm6",
    "libXext.so.6": "libxext6",
    "libXfixes.so.3": "libxfixes3",
    "libXi.so.6": "libxi6",
    "libXrender.so.1": "libxrender1",
    "libXt.so.6": "libxt6",
    "libxkbcommon.so.0": "libxkbcommon0",
}
# What Gmsh loads besides.
GMSH_LIBRARIES = {
    "libGLU.so.1": "libglu1-mesa",
    "libXcursor.so.1": "libxcursor1",
    "libXft.so.2": "libxft2",
    "libXinerama.so.1": "libxinerama1",
    "libgomp.so.1": "libgomp1",
}


class SetupError(Exception):
    """The machine lacks something that cannot be installed from here."""


def make_environments(folder):
    """Returns each viewer's command; it takes a file to write its readings to, then meshes."""
    folder.mkdir(parents=True, exist_ok=True)
    python = find_python()
    install_system_packages(python)
    meshlab = make_venv(python, folder / "meshlab", HERE / "meshlab.requirements.txt")
    blender = make_venv(python, folder / "blender", HERE / "blender.requirements.txt")
    validator = make_node_folder(folder / "validator", HERE / "validator.package.json")
    return {
        # -B: leave no compiled files in the source tree.
        "MeshLab": [meshlab, "-B", HERE / "meshlab.py"],
        "Blender": [blender, "-B", HERE / "blender.py"],
        "validator": ["node", HERE / "validator.mjs", validator],
    }


def find_python():
    """Blender's package is built for Python 3.11 and installs into no other."""
    for name in ("python3.11", "python3"):
        if not shutil.which(name):
            continue
        # Asked rather than assumed: a version manager may list a name that it cannot start.
        question = [name, "-c", "import sys; print('%d.%d' % sys.version_info[:2])"]
        answer = subprocess.run(question, capture_output=True, text=True)
        if answer.stdout.strip() == "3.11":
            return name
    raise SetupError("the viewers need Python 3.11, as python3.11 or python3 on the PATH")


def install_system_packages(python, more_libraries=None):
    libraries = {**SYSTEM_LIBRARIES, **(more_libraries or {})}
    packages = [name for library, name in libraries.items() if not loads(library)]
    # Debian ships Python without the part that puts pip into a new environment.
    if subprocess.run([python, "-c", "import ensurepip"], capture_output=True).returncode:
        packages.append("python3.11-venv")
    if not packages:
        return
    if os.geteuid() != 0 or not shutil.which("apt-get"):
        raise SetupError("install these first (Debian's names): " + " ".join(packages))
    print("installing", *packages, flush=True)
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    run(["apt-get", "update", "-qq"], env=quiet)
    run(["apt-get", "install", "-y", "-qq", "--no-install-recommends", *packages], env=quiet)


def loads(library):
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def make_venv(python, environment, requirements):
    interpreter = environment / "bin" / "python"
    if not (interpreter.exists() and is_current(environment, requirements)):
        print(f"making the environment {environment}", flush=True)
        shutil.rmtree(environment, ignore_errors=True)
        run([python, "-m", "venv", environment])
        run([interpreter, "-m", "pip", "install", "--quiet", "-r", requirements])
        remember(environment, requirements)
    return interpreter


def add_alone(interpreter, requirement, folder):
    """A package without those that it asks for, where one of its modules is enough."""
    if not folder.is_dir():
        print(f"installing {requirement}", flush=True)
        command = [interpreter, "-m", "pip", "install", "--quiet", "--no-deps", "--target", folder, requirement]
        run(command)


def make_node_folder(environment, package):
    if not shutil.which("node") or not shutil.which("npm"):
        raise SetupError("the glTF validator needs node and npm on the PATH")
    if not is_current(environment, package):
        print(f"making the environment {environment}", flush=True)
        shutil.rmtree(environment, ignore_errors=True)
        environment.mkdir()
        shutil.copy(package, environment / "package.json")
        run(["npm", "install", "--silent", "--no-package-lock"], cwd=environment)
        remember(environment, package)
    return environment


def is_current(environment, pins):
    remembered = environment / "pins"
    return remembered.is_file() and remembered.read_bytes() == pins.read_bytes()


def remember(environment, pins):
    """Written last, so that an installation cut short is not taken for a finished one."""
    shutil.copy(pins, environment / "pins")


def run(command, **options):
    """Runs an installer; its output is of interest only when it fails."""
    finished = subprocess.run(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
    )
    if finished.returncode:
        shown = " ".join(map(str, command))
        raise SetupError(f"{shown} failed:\n{finished.stdout.strip()[-3000:]}")


if __name__ == "__main__":
    # For tests that make an environment of their own: the libraries of all viewers.
    install_system_packages(sys.executable, GMSH_LIBRARIES)
