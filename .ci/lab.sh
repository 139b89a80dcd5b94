#!/bin/sh
# JupyterLab with our kernel, in a Python environment of its own:
#
#     lab.sh install    makes the environment build/lab, if it is not there
#     lab.sh notebooks  makes notebooks of examples, build/notebooks
#     lab.sh start      does both, and opens JupyterLab at them
#     lab.sh test       installs, and runs the tests of the kernel
#     lab.sh bench      installs, and measures thirty kernels at once
#
# Versions are those of requirements.txt.  Python's part for environments is installed on Debian and
# Ubuntu, as Racket is; elsewhere it says what to install.

set -eu
cd "$(dirname "$0")/.."

lab=build/lab
notebooks=build/notebooks
root=
python=${PYTHON:-python3}
wanted=mechanics/notebook/python/requirements.txt

say() { printf '%s\n' "$*" >&2; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then env DEBIAN_FRONTEND=noninteractive "$@"
    elif [ -t 0 ]; then sudo env DEBIAN_FRONTEND=noninteractive "$@"
    else sudo -n env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

environments() { "$python" -c 'import ensurepip, venv' >/dev/null 2>&1; }

ensure_python() {
    environments && return
    if command -v apt-get >/dev/null 2>&1; then
        say 'Installing python3-venv ...'
        { as_root apt-get update -qq && as_root apt-get install -y -qq python3-venv; } >&2 || :
    fi
    environments && return
    say "Notebooks need Python 3.9 or later with its module venv:
  Debian, Ubuntu   apt-get install python3-venv
  Fedora           dnf install python3
  macOS            brew install python
Then run the same make command again."
    exit 1
}

install() {
    if ! cmp -s "$wanted" "$lab/installed.txt"; then
        ensure_python
        say "Installing JupyterLab in $lab: some 200 MB, about a minute ..."
        rm -rf "$lab"
        mkdir -p build
        "$python" -m venv "$lab"
        "$lab/bin/pip" install -q --disable-pip-version-check -r "$wanted" >&2 || {
            say 'The packages could not be installed; is the package index within reach?'
            exit 1
        }
        cp "$wanted" "$lab/installed.txt"
    fi
    "${RACKET:-racket}" -l- mechanics/lang/command/raco jupyter \
        --prefix "$lab" --python "$PWD/$lab/bin/python" >/dev/null
}

# Bound to this machine alone, with a token.  Server and kernels talk over sockets in a folder of
# the user's own, where the names of those are short enough for the system; else by ports.
start() {
    transport=ipc
    home=${HOME:-}
    [ "${#home}" -le 25 ] || transport=tcp
    say 'JupyterLab opens in the browser; without one, its address is below.  Ctrl-C twice ends it.'
    exec env JUPYTER_CONFIG_DIR="$PWD/build/lab-config" "$lab/bin/jupyter" lab \
        --ServerApp.ip=127.0.0.1 --KernelManager.transport="$transport" \
        --MappingKernelManager.default_kernel_name=mechanics \
        --ServerApp.root_dir="$PWD/$notebooks" $root "$@"
}

# Those of the examples with controls; what the reader changed stays.
make_notebooks() {
    mkdir -p "$notebooks/interactive"
    for program in examples/mechanics/interactive/*.rkt; do
        made="$notebooks/interactive/$(basename "$program" .rkt).ipynb"
        case $program in */info.rkt) continue ;; esac
        [ -e "$made" ] || "${RACKET:-racket}" -l- mechanics/lang/command/raco notebook \
            -o "$made" "$program" >/dev/null
    done
}

case ${1:-} in
    install) install ;;
    notebooks) make_notebooks ;;
    start)   install
             make_notebooks
             [ "$(id -u)" -ne 0 ] || root=--allow-root
             shift
             start "$@" ;;
    test)    install
             "$lab/bin/pip" install -q --disable-pip-version-check \
                 -r tests/mechanics/notebook/lab/requirements.txt >&2
             exec "$lab/bin/python" tests/mechanics/notebook/lab/run.py ;;
    bench)   install
             exec "$lab/bin/python" tests/mechanics/notebook/lab/bench.py ;;
    *)       say 'lab.sh install, notebooks, start, test or bench'; exit 2 ;;
esac
