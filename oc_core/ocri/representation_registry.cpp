// Built-in and registered representations, and their names.
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/registry.h"
#include "oc_core/ocri/builtin_representations.h"

namespace ocelli {
namespace {

/// N of "ldi-N" for a kind that takes such names, 0 where it is none.
int countFromName(const RepresentationKind& kind, std::string_view name) {
  const std::string_view own = kind.name;
  const std::string_view stem = own.substr(0, own.rfind('-') + 1);
  if (kind.maxCount == 0 || !name.starts_with(stem) || name.substr(stem.size()).starts_with('0')) {
    return 0;
  }
  const int count = numberFromText<int>(name.substr(stem.size())).value_or(0);
  return count >= 1 && count <= kind.maxCount ? count : 0;
}

bool answersTo(const RepresentationKind& kind, std::string_view name) {
  return name == kind.name || (*kind.otherName != '\0' && name == kind.otherName) || countFromName(kind, name) > 0;
}

Registry<RepresentationKind>& representationRegistry() {
  static Registry<RepresentationKind> registry("representation", builtinRepresentations(), answersTo);
  return registry;
}

}  // namespace

Rows<RepresentationKind> representationKinds() {
  return representationRegistry().rows();
}

std::optional<NamedRepresentation> findRepresentation(std::string_view name) {
  for (const RepresentationKind& kind : representationKinds()) {
    if (answersTo(kind, name)) {
      return NamedRepresentation{&kind, countFromName(kind, name)};
    }
  }
  return std::nullopt;
}

void registerRepresentation(RepresentationKind kind) {
  const std::string name = kind.name;
  if (name.empty() || name.ends_with(".json")) {
    throw InputError("a representation cannot have this name", "\"" + name + "\"",
                     "give it one that is no file's: what ends in .json is read as one");
  }
  if (static_cast<bool>(kind.images) == static_cast<bool>(kind.mesh)) {
    throw InputError("a representation has either images or a mesh", name, "set one of the two functions of its row");
  }
  representationRegistry().add(std::move(kind));
}

}  // namespace ocelli
