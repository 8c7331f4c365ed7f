# Read by what starts programs of this archive, which sets $here: what they need of it besides bin/ and lib/.
#
# Libraries that drivers of the machine were made for in another version than ours, are taken from fallback/ only where the machine
# has none.
known=$(ldconfig -p 2>/dev/null || /sbin/ldconfig -p 2>/dev/null || true)
for folder in "$here"/fallback/*; do
  case $known in
    *"$(basename "$folder") "*) ;;
    *) LD_LIBRARY_PATH="${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$folder" ;;
  esac
done
[ -z "${LD_LIBRARY_PATH-}" ] || export LD_LIBRARY_PATH
