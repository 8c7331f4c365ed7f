// The free part of a `.svol` header: a JSON object that tells what made the volumes.
//
// Ours are `software`, `scene` and `dither`, as texts; a tool may add any other field.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ocelli::svol {

/// Throws InputError for anything but a JSON object of at most 1 MiB; `where` names the file.
void requireMetadata(const std::string& text, const std::string& where);

/// Its fields in their order, texts as they are and other values as JSON. The text must have passed requireMetadata().
std::vector<std::pair<std::string, std::string>> metadataFields(const std::string& text);

/// The object with one more field, or another value in it.
std::string withField(const std::string& text, const std::string& name, const std::string& value);

}  // namespace ocelli::svol
