# A Python with packages of its own.
. tests/target.sh

# python_with NAME PACKAGE …: sets `python`, in a folder of that name. Where it cannot be had the script ends with a
# line that says so; with CI set that is a failure.
python_with() {
    local folder
    folder=$(realpath -m "${CARGO_TARGET_DIR:-target}/tools/$1")
    python=$folder/bin/python
    # Written last: an installation that was broken off is none.
    if [ "$(cat "$folder/packages" 2>/dev/null)" = "${*:2}" ]; then return; fi
    if [ -n "${CI:-}" ] && ! python3 -c 'import ensurepip, venv' 2>/dev/null; then
        install python3 python3-venv
    fi
    if python3 -m venv "$folder" && "$python" -m pip install --quiet "${@:2}"; then
        echo "${*:2}" >"$folder/packages"
    elif [ -n "${CI:-}" ]; then
        echo "$1: ${*:2} cannot be installed" >&2
        exit 1
    else
        echo "skipped: no Python with ${*:2}"
        exit 0
    fi
}
