#include "oc_core/window/monitors.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <span>

#include "oc_core/gl/gl_error.h"

namespace ocelli {

std::string lastGlfwError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? std::string(" (") + description + ")" : "";
}

std::string windowSystemVersion() {
  return glfwGetVersionString();
}

void initializeGlfw() {
  if (glfwInit() == GLFW_TRUE) {
    return;
  }
  const char* display = std::getenv("DISPLAY");
  const bool named = display != nullptr && *display != '\0';
  throw GlError("no display can be opened" + lastGlfwError(), named ? "DISPLAY=" + std::string(display) : "DISPLAY",
                "set DISPLAY to a running X server, or use --offscreen");
}

std::vector<Monitor> listMonitors() {
  initializeGlfw();
  int count = 0;
  GLFWmonitor** const found = glfwGetMonitors(&count);
  std::vector<Monitor> monitors;
  for (GLFWmonitor* monitor : std::span(found, static_cast<size_t>(count))) {
    Monitor& one = monitors.emplace_back();
    one.name = glfwGetMonitorName(monitor);
    if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
      one.width = mode->width;
      one.height = mode->height;
      one.refreshHertz = mode->refreshRate;
    }
    glfwGetMonitorPos(monitor, &one.left, &one.top);
    glfwGetMonitorPhysicalSize(monitor, &one.widthMillimeters, &one.heightMillimeters);
  }
  return monitors;
}

}  // namespace ocelli
