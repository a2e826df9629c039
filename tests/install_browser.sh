#!/bin/sh
# Install Debian's chromium with its driver. Fails where that takes rights, a system or a network that are not there.
set -eu
test "$(id -u)" = 0
command -v apt-get >/dev/null
export DEBIAN_FRONTEND=noninteractive
set -- --quiet=2 -o Acquire::http::Timeout=30 -o Acquire::Retries=1
timeout 120 apt-get update "$@"
timeout 600 apt-get install --yes --no-install-recommends "$@" chromium chromium-driver
