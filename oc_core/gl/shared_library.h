// Functions of a library that is opened at run time: a program that may use it starts without it.
#pragma once

#include <string>

namespace ocelli {

class SharedLibrary {
 public:
  using Function = void (*)();

  /// Throws GlError where it is not installed; `package` is the one to install. It stays open until the program ends:
  /// graphics drivers do not survive being unloaded.
  SharedLibrary(const char* file, const char* package);

  /// nullptr where it has none of this name.
  Function find(const char* name) const;
  /// Throws GlError where it has none of this name.
  template <class Signature>
  Signature* get(const char* name) const {
    return reinterpret_cast<Signature*>(require(name));
  }

 private:
  Function require(const char* name) const;

  std::string file_;
  std::string package_;
  void* handle_;
};

}  // namespace ocelli
