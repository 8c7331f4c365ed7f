// The kinds of handles, each defined in one of the *_handles.cpp files. For handle_kinds.cpp alone.
#pragma once

#include "oc_core/frustum_editor/handle_kinds.h"

namespace ocelli {

HandleKind eyeHandle();
HandleKind targetHandle();
HandleKind fieldOfViewHandle();
HandleKind viewpointHandle();
HandleKind aimHandle();
HandleKind planeHandle();
HandleKind planeEndHandle();
HandleKind splitEdgeHandle();
HandleKind partBorderHandle();
HandleKind limitHandle();
HandleKind limitEndHandle();
HandleKind turnMiddleHandle();
HandleKind turnLineHandle();
HandleKind turnPlaneHandle();

}  // namespace ocelli
