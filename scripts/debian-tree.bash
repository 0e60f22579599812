# Fresh trees of Debian 12, for scripts/make-release and scripts/try-packages, which source this file.

fail() {
    echo "${0##*/}: $*" >&2
    exit 1
}

needs_root() {
    [[ $(id -u) -eq 0 ]] || fail "expected root, since it sets up trees of Debian: sudo $0"
    [[ $(dpkg --print-architecture) == amd64 ]] || fail "expected a machine of the architecture amd64"
}

# make_tree FOLDER ARCHITECTURES PACKAGE...: nothing but what Debian calls essential, apt, and these packages. As in the
# image debian:12-slim, documents and manual pages are left out.
make_tree() {
    local folder=$1 architectures=$2
    shift 2
    local IFS=,
    mmdebstrap --quiet --mode=root --variant=minbase --architectures="$architectures" --components=main \
        ${1:+--include="$*"} --skip=cleanup/apt/lists --aptopt='APT::Install-Recommends "false"' \
        --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
        --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-include=/usr/share/doc/*/copyright' bookworm "$folder"
}

# in_tree FOLDER COMMAND...: runs it there as root. /proc is there meanwhile, and this machine's network.
in_tree() {
    unshare --mount bash -c 'cp /etc/resolv.conf "$0/etc/" && mount -t proc proc "$0/proc" && exec chroot "$@"' "$1" "$1" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${SOURCE_DATE_EPOCH:+SOURCE_DATE_EPOCH="$SOURCE_DATE_EPOCH"} "${@:2}"
}
