// The built-in scenes, each defined in its own file. For builtin_scenes.cpp alone.
#pragma once

#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {

BuiltinScene barrelsScene();
BuiltinScene boxScene();
BuiltinScene boxesScene();
BuiltinScene canyonScene();
BuiltinScene cityScene();
BuiltinScene corridorScene();
BuiltinScene corridorTScene();
BuiltinScene courtyardScene();
BuiltinScene crowdScene();
BuiltinScene dnaScene();
BuiltinScene doorsScene();
BuiltinScene fenceScene();
BuiltinScene houseScene();
BuiltinScene lampScene();
BuiltinScene lensScene();
BuiltinScene libraryScene();
BuiltinScene mazeScene();
BuiltinScene mirrorMazeScene();
BuiltinScene mirrorScene();
BuiltinScene museumScene();
BuiltinScene officeScene();
BuiltinScene parkingScene();
BuiltinScene particlesScene();
BuiltinScene pergolaScene();
BuiltinScene roomScene();
BuiltinScene shopScene();
BuiltinScene sphereScene();
BuiltinScene statuesScene();
BuiltinScene teapotScene();
BuiltinScene torusScene();
BuiltinScene townScene();
BuiltinScene treeScene();
BuiltinScene wavingScene();

}  // namespace ocelli
