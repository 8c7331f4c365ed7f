// Which key stands for what a device sends: "South=Enter,Left=Left" or "1=1,a=Left,0x41=-1".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/input_event.h"

namespace ocelli {

struct KeyMapEntry {
  std::string from;  ///< what the device sends, as the user wrote it
  Key key = Key::kSpace;
  bool releases = false;  ///< written "-KEY": it says that the key was released
};

/// Of entries "FROM=KEY", separated by commas; KEY as nameOf(Key) has it. A "," is written 0x2c, and "=" 0x3d. `where`
/// is for messages. Throws InputError.
std::vector<KeyMapEntry> keyMapFromText(std::string_view text, const std::string& where);

}  // namespace ocelli
