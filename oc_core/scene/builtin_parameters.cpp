#include "oc_core/scene/builtin_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

std::string rangeText(const BuiltinParameter& parameter) {
  return fmt::format("{} from {:.15g} to {:.15g}",
                     parameter.kind == BuiltinParameter::Kind::kInteger ? "a whole number" : "a number",
                     parameter.least, parameter.most);
}

}  // namespace

class BuiltinReader {
 public:
  BuiltinReader(const std::vector<BuiltinParameter>& parameters, const BuiltinOwner& owner, const std::string& source)
      : parameters_(parameters), owner_(owner), source_(source) {
    for (const BuiltinParameter& parameter : parameters_) {
      set(parameter, parameter.otherwise);
    }
  }

  void read(const std::string& piece) {
    const size_t equals = piece.find('=');
    const std::string key = piece.substr(0, equals);
    if (equals == std::string::npos) {
      throw InputError("'" + piece + "' is not of the form key=value", source_, validKeys());
    }
    for (const BuiltinParameter& parameter : parameters_) {
      if (parameter.name == key) {
        if (!values_.given_.insert(key).second) {
          throw InputError("'" + key + "' is given twice", source_, "leave one of them out");
        }
        set(parameter, piece.substr(equals + 1));
        return;
      }
    }
    throw InputError(owner_.called + " has no parameter '" + key + "'", source_, validKeys());
  }

  const BuiltinValues& values() const { return values_; }

 private:
  std::string validKeys() const {
    return parameters_.empty() ? owner_.example + " takes no parameters"
                               : "one of " + listNames(parameters_) + ", for example " + owner_.example + "," +
                                     parameters_[0].name + "=" + parameters_[0].otherwise;
  }

  void set(const BuiltinParameter& parameter, const std::string& text) {
    if (parameter.kind == BuiltinParameter::Kind::kFile) {
      values_.paths_[parameter.name] = text;
      return;
    }
    const std::optional<double> value = numberFromText<double>(text);
    const bool whole = parameter.kind != BuiltinParameter::Kind::kInteger || (value && *value == std::floor(*value));
    if (!value || !whole || *value < parameter.least || *value > parameter.most) {
      throw InputError("the value of '" + parameter.name + "' is '" + text + "', which is not " + rangeText(parameter),
                       source_, fmt::format("{}={}", parameter.name, parameter.otherwise));
    }
    values_.numbers_[parameter.name] = *value;
  }

  const std::vector<BuiltinParameter>& parameters_;
  const BuiltinOwner& owner_;
  const std::string& source_;
  BuiltinValues values_;
};

double BuiltinValues::number(const std::string& name) const {
  const auto found = numbers_.find(name);
  OC_CHECK(found != numbers_.end(), "a scene asks for the parameters that it lists");
  return found->second;
}

size_t BuiltinValues::count(const std::string& name) const {
  return static_cast<size_t>(number(name));
}

const std::string& BuiltinValues::path(const std::string& name) const {
  const auto found = paths_.find(name);
  OC_CHECK(found != paths_.end(), "a scene asks for the parameters that it lists");
  return found->second;
}

BuiltinValues readBuiltinValues(const std::vector<BuiltinParameter>& parameters, std::span<const std::string> pieces,
                                const BuiltinOwner& owner, const std::string& source) {
  BuiltinReader reader(parameters, owner, source);
  for (const std::string& piece : pieces) {
    reader.read(piece);
  }
  return reader.values();
}

std::vector<std::string> splitAtCommas(std::string_view text) {
  std::vector<std::string> pieces(1);
  for (const char c : text) {
    if (c == ',') {
      pieces.emplace_back();
    } else {
      pieces.back() += c;
    }
  }
  return pieces;
}

}  // namespace ocelli
