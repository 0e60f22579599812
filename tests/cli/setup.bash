# The tests here source this file. It gives them a folder of their own to work in, and the functions expect and
# check_page.
support=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../support" && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"

# expect CODE TEXT COMMAND...: fails unless the command ends with CODE and its output contains TEXT.
expect() {
    local code=$1 text=$2 output status=0
    shift 2
    output=$("$@" 2>&1) || status=$?
    if [[ $status -ne $code || $output != *"$text"* ]]; then
        printf 'FAILED: %s\nexpected exit code %s and "%s", got %s and:\n%s\n' "$*" "$code" "$text" "$status" "$output"
        exit 1
    fi
}

# check_page FILE HEADING...: fails unless the report is one valid page that loads nothing from outside and has these
# sections.
check_page() { python3 "$support/check_page.py" "$@"; }
