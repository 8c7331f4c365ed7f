#!/bin/sh
# scripts/build_site.sh [FOLDER]: makes the guide of docs/ a site of web pages in FOLDER, build/site by default, which needs no
# server and nothing from elsewhere. Needs Debian's packages mkdocs and mkdocs-material.
set -eu
folder=$(realpath -m "${1:-$(dirname "$0")/../build/site}")
cd "$(dirname "$0")/.."

# Debian's, whatever Python comes first on the path.
if ! /usr/bin/python3 -c 'import mkdocs' 2>/dev/null; then
  echo "build_site: mkdocs is missing: apt-get install --no-install-recommends mkdocs mkdocs-material" >&2
  exit 77
fi
/usr/bin/python3 -m mkdocs build --quiet --config-file docs/site/mkdocs.yml --site-dir "$folder"
echo "wrote $folder/index.html"
