#include "analysis/report/part_guard.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/base/failure.h"

namespace ocelli {

std::string addFailure(ReportWork& work, const std::string& what, const std::string& failure) {
  work.document.failures.push_back(fmt::format("{}: {}", what, failure));
  return fmt::format("the computation failed, which is a fault of the program ({})", failure);
}

void addPart(ReportWork& work, const std::string& what, const std::function<void()>& add) {
  if (const std::optional<std::string> failure = failureOf(add)) {
    addNotEstimable(work.document, what, addFailure(work, what, *failure));
  }
}

void addFigure(ReportWork& work, const std::string& caption, const std::string& id,
               const std::function<Figure()>& draw) {
  const std::string what = fmt::format("The figure \"{}\"", caption);
  addPart(work, what, [&] {
    Figure figure = draw();
    if (isFinite(figure.drawing) && std::isfinite(figure.width) && std::isfinite(figure.height)) {
      work.document.add(ReportFigure{caption, id, std::move(figure)});
    } else {
      addNotEstimable(work.document, what, addFailure(work, what, "a place in it is not finite"));
    }
  });
}

}  // namespace ocelli
