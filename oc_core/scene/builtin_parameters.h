// What the names of things that are made by code say of them: `builtin:NAME,key=value,...`.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

struct BuiltinParameter {
  enum class Kind {
    kInteger,
    kNumber,
    kFile,  ///< a path; as given, else below $OCELLI_DATA_DIR
  };

  std::string name;
  std::string summary;  ///< what it is, with its unit
  Kind kind = Kind::kNumber;
  std::string
      otherwise;     ///< what stands where the user gives none, as the user would write it; may be empty for a path
  double least = 0;  ///< both included; of no meaning for a path
  double most = 0;
};

/// The values of a scene's parameters, checked against their kinds and ranges.
class BuiltinValues {
 public:
  double number(const std::string& name) const;
  size_t count(const std::string& name) const;
  const std::string& path(const std::string& name) const;
  /// Whether the user gave it.
  bool isGiven(const std::string& name) const { return given_.contains(name); }

 private:
  friend class BuiltinReader;
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> paths_;
  std::set<std::string> given_;
};

/// What parameters belong to, as messages name it.
struct BuiltinOwner {
  std::string called;   ///< "the scene maze"
  std::string example;  ///< what stands before ",key=value": "builtin:maze"
};

/// The values that `pieces` ("key=value") give, and those that stand where none is given. `source` is the whole name,
/// as the user wrote it. Throws InputError that lists the keys or the range for an unknown, repeated or malformed
/// parameter, or a value out of range.
BuiltinValues readBuiltinValues(const std::vector<BuiltinParameter>& parameters, std::span<const std::string> pieces,
                                const BuiltinOwner& owner, const std::string& source);

/// "a,b" becomes "a" and "b"; there is always one piece.
std::vector<std::string> splitAtCommas(std::string_view text);

/// "one, two", of what has names.
template <class Named>
std::string listNames(const std::vector<Named>& list) {
  std::string names;
  for (const Named& each : list) {
    names += (names.empty() ? "" : ", ") + each.name;
  }
  return names;
}

}  // namespace ocelli
