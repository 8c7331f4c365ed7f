// Whether columns of a logistic model separate its answers: then some coefficients grow without end, and the model has
// no estimate (Albert and Anderson 1984).
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/models/design.h"

namespace ocelli {

/// Which coefficients have no finite estimate: those of a direction d with row d >= 0 where all trials of a row were
/// successes, <= 0 where none was, = 0 where some were, and not 0 for all rows. Empty where there is no such direction.
/// `rows`: rows x columns of full rank, best of similar length; `successes` of `trials` of each row, 1 or more.
///
/// By projections in turns on the columns' span and on the directions that are not negative, from a start that has a
/// part of each of these: they end at 0 exactly where none lies in the span. This is the check of Correia, Guimaraes,
/// Zylkin 2019 (Verifying the existence of maximum likelihood estimates, section 3) without its weights.
std::vector<Eigen::Index> separatedColumns(const Eigen::MatrixXd& rows, const Eigen::VectorXd& successes,
                                           const Eigen::VectorXd& trials);
/// The names of these columns of a design, whatever their units.
std::vector<std::string> separatedCoefficients(const Design& design, const Eigen::VectorXd& successes,
                                               const Eigen::VectorXd& trials);

}  // namespace ocelli
