// The device `text`, or `text:COLUMNS`: each volume that is shown is printed as letters, as it looks from the front.
#pragma once

#include "display_driver/devices/device_kinds.h"

ocelli::DeviceKind textDevice();
