// The version of this program, as databases record it.
#pragma once

namespace ocelli {

const char* programVersion();

}  // namespace ocelli
