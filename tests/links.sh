#!/usr/bin/env bash
# Checks the links of the documentation: those between items, by `cargo doc`, and the relative ones of every
# Markdown file, whose targets must exist. What belongs to the package `core` links to nothing outside of it.
#   tests/links.sh            both
#   tests/links.sh --files    Markdown files alone
set -euo pipefail
cd "$(dirname "$0")/.."

# links FILE: its line numbers and relative targets, code left out.
links() {
    awk '
        /^ *(```|~~~)/ { code = !code; next }
        code { next }
        {
            gsub(/`[^`]*`/, "code")
            rest = $0
            while (match(rest, /\]\([^)]*\)/)) {
                print FNR, substr(rest, RSTART + 2, RLENGTH - 3)
                rest = substr(rest, RSTART + RLENGTH)
            }
            if (match($0, /^ *\[[^]]+\]: */)) print FNR, substr($0, RSTART + RLENGTH)
        }
    ' "$1" | awk '$2 !~ /^([a-z]+:|#|$)/ { sub(/#.*/, "", $2); print $1, $2 }'
}

broken=0
complain() { echo "links: $*" >&2 && broken=1; }

# check ROOT FILE: its targets, which are to lie under ROOT.
check() {
    local line target
    while read -r line target; do
        local path
        path=$(realpath -m "$(dirname "$2")/$target")
        if [ ! -e "$path" ]; then
            complain "$2:$line: $target does not exist"
        elif [[ $path/ != "$(realpath "$1")"/* ]]; then
            complain "$2:$line: $target is outside of $1"
        fi
    done < <(links "$2")
}

# A check that finds nothing wrong with this page finds nothing anywhere.
page=$(mktemp -d)
trap 'rm -r "$page"' EXIT
printf '[a](there.md) [b](gone.md)\n\n```\n[c](code.md)\n```\n`[d](code.md)`\n[e]: lost.md\n[f](https://a.b/c)\n' >"$page/page.md"
touch "$page/there.md"
found=$(check "$page" "$page/page.md" 2>&1 | grep -o '[a-z]*\.md does not exist' | cut -d. -f1 | xargs)
if [ "$found" != "gone lost" ]; then
    echo "links: of a page with two broken links it finds: $found" >&2
    exit 1
fi

files=0
while read -r file; do
    case $file in
    core/*) check core "$file" ;;
    *) check . "$file" ;;
    esac
    files=$((files + 1))
done < <(git ls-files --cached --others --exclude-standard '*.md')
[ "$files" -gt 0 ] || complain "no Markdown file"

if [ "${1:-}" != --files ]; then
    # Every warning of rustdoc counts, broken links among them.
    export RUSTDOCFLAGS="${RUSTDOCFLAGS:-} -D warnings"
    cargo doc --workspace --no-deps --locked --quiet
    cargo doc --package schuler --features full --no-deps --locked --quiet
fi
[ "$broken" = 0 ] || exit 1
echo "links: $files Markdown files, every relative link leads somewhere"
