#include "analysis/report/r_functions.h"

namespace ocelli {

const char* const kRFunctions = R"R(
needed <- c("lme4", "lmerTest", "survival")
absent <- needed[!vapply(needed, requireNamespace, logical(1), quietly = TRUE)]
if (length(absent) > 0) {
  stop("install.packages(c(", paste0('"', absent, '"', collapse = ", "), "))", call. = FALSE)
}
suppressPackageStartupMessages({
  library(lme4)
  library(lmerTest)
  library(survival)
})

# The folder that this script lies in.
script <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
folder <- if (length(script) == 1) dirname(script) else "."

read <- function(name) {
  columns <- c(subject_id = "character", block = "character", item = "character", answer = "character",
               expected = "character", field = "character")
  path <- file.path(folder, "tables", name)
  header <- names(read.csv(path, nrows = 1, check.names = FALSE))
  read.csv(path, na.strings = "", colClasses = columns[names(columns) %in% header])
}

results <- data.frame()
keep <- function(model, term, estimate, lower = NA, upper = NA, p = NA) {
  results <<- rbind(results, data.frame(model = model, term = term, estimate = estimate, lower = lower, upper = upper,
                                        p = p, row.names = NULL))
}
# A model that cannot be fitted says why, and the others follow.
attempt <- function(model, work) {
  tryCatch(work(), error = function(problem) cat(model, ": ", conditionMessage(problem), "\n", sep = ""))
}

# Columns as the models take them: two-level factors are -0.5 and 0.5, numbers are less their mean, so that each
# coefficient is that of an average trial. Trials without a value of `terms` are left out.
prepare <- function(trials, terms) {
  sources <- c(view = "view", session = "session_number", moving = "moving", exposure = "exposure_s",
               duplicates = "duplicate_colors", objects = "objects", trial = "plan_index")
  used <- unique(unlist(strsplit(terms, ":", fixed = TRUE)))
  columns <- trials[sources[used]]
  trials <- trials[rowSums(is.na(columns)) == 0, ]
  prepared <- trials[c("subject_id", "item", "correct", "censored", "response_s")]
  names(prepared)[1:2] <- c("subject", "case")
  for (term in used) {
    values <- trials[[sources[[term]]]]
    prepared[[term]] <- switch(term,
                               view = ifelse(values == "@other@", 0.5, -0.5),
                               moving = ,
                               duplicates = values - 0.5,
                               values - mean(values))
  }
  prepared
}
formula_of <- function(response, terms, random) {
  as.formula(paste(response, "~", paste(c("1", terms, random), collapse = " + ")))
}

keep_coefficients <- function(model, table, degrees, p, shown = exp) {
  for (term in setdiff(rownames(table), "(Intercept)")) {
    half <- qt(0.975, degrees[[term]]) * table[term, "Std. Error"]
    estimate <- table[term, "Estimate"]
    keep(model, term, shown(estimate), shown(estimate - half), shown(estimate + half), table[term, p])
  }
}

# The random effects that are fitted of those that were planned, by the report's steps: intercepts without correlations; a
# slope stays where three levels have two trials at each of two values of it, where the effects are fewer than the
# trials, and where the restricted deviance rises by 0.4549 or more without it (p < 0.25 of a variance at its boundary).
random_terms <- function(slopes) {
  vapply(names(slopes), function(group) {
    if (length(slopes[[group]]) == 0) sprintf("(1 | %s)", group)
    else sprintf("(1 + %s || %s)", paste(slopes[[group]], collapse = " + "), group)
  }, "")
}
# Those by cases first, from the last one on.
slopes_in_order <- function(slopes) {
  groups <- names(slopes)[order(names(slopes) != "case")]
  do.call(rbind, lapply(groups, function(group) {
    if (length(slopes[[group]]) > 0) data.frame(group = group, slope = rev(slopes[[group]]))
  }))
}
without_slope <- function(slopes, place) {
  slopes[[place$group]] <- setdiff(slopes[[place$group]], place$slope)
  slopes
}
slopes_by_design <- function(data, slopes) {
  order <- slopes_in_order(slopes)
  for (i in seq_len(NROW(order))) {
    place <- order[i, ]
    values <- Reduce(`*`, data[strsplit(place$slope, ":", fixed = TRUE)[[1]]])
    levels <- sum(rowSums(table(data[[place$group]], values) >= 2) >= 2)
    effects <- length(unique(data[[place$group]])) * (1 + length(slopes[[place$group]]))
    if (levels < 3 || effects >= nrow(data)) slopes <- without_slope(slopes, place)
  }
  slopes
}
# `fit`: of random terms; gives a list with the restricted `deviance`.
fit_by_rule <- function(data, slopes, fit) {
  slopes <- slopes_by_design(data, slopes)
  best <- fit(random_terms(slopes))
  repeat {
    order <- slopes_in_order(slopes)
    if (NROW(order) == 0) return(best)
    others <- lapply(seq_len(nrow(order)), function(i) fit(random_terms(without_slope(slopes, order[i, ]))))
    rises <- vapply(others, function(other) other$deviance, 1) - best$deviance
    least <- which.min(rises)
    if (rises[least] >= 0.4549) return(best)
    slopes <- without_slope(slopes, order[least, ])
    best <- others[[least]]
  }
}

# Ratios of geometric means; restricted likelihood, Satterthwaite's degrees of freedom. `timeouts`: "censored", "removed",
# "set_to_limit". Of censored times these packages have no model with crossed random effects: where there are any, a
# log-normal regression with errors robust to clusters stands in, under names of its own.
times_model <- function(model, trials, timeouts, terms, slopes) attempt(model, function() {
  data <- prepare(trials[!is.na(trials$response_s) & trials$response_s > 0, ], terms)
  if (timeouts == "removed") data <- data[!(data$censored %in% 1), ]
  if (timeouts == "censored" && any(data$censored %in% 1)) {
    cat(model, ": R's packages have no mixed model of censored times with crossed random effects. What follows is a",
        " log-normal regression with clusters; the report's estimates are near these, and not the same.\n", sep = "")
    return(log_normal_fit(model, data, 1 - (data$censored %in% 1), terms, "case" %in% names(slopes), ", survreg"))
  }
  if (length(slopes) == 0) {
    fit <- lm(formula_of("log(response_s)", terms, c()), data)
    table <- coef(summary(fit))
    degrees <- setNames(rep(fit$df.residual, nrow(table)), rownames(table))
  } else {
    control <- lmerControl(optCtrl = list(xtol_abs = 1e-10, ftol_abs = 1e-12), check.conv.singular = "ignore")
    fit <- fit_by_rule(data, slopes, function(random) {
      fit <- lmerTest::lmer(formula_of("log(response_s)", terms, random), data, control = control)
      list(fit = fit, deviance = REMLcrit(fit))
    })$fit
    table <- coef(summary(fit))
    degrees <- setNames(table[, "df"], rownames(table))
  }
  print(summary(fit))
  keep_coefficients(model, table, degrees, "Pr(>|t|)")
})

# Of estimates in `unit`, the error with its sign (of lengths log(estimate / truth), of directions degrees), or the
# logarithm of its absolute value, where an error of 0 counts with half of the smallest one above 0.
error_model <- function(model, trials, unit, absolute, terms, slopes) attempt(model, function() {
  data <- prepare(trials[trials$unit %in% unit, ], terms)
  data$error <- data$signed_error
  if (absolute) {
    data$error <- abs(data$error)
    data$error[data$error == 0] <- min(data$error[data$error > 0]) / 2
    data$error <- log(data$error)
  }
  control <- lmerControl(optCtrl = list(xtol_abs = 1e-10, ftol_abs = 1e-12), check.conv.singular = "ignore")
  fit <- fit_by_rule(data, slopes, function(random) {
    fit <- lmerTest::lmer(formula_of("error", terms, random), data, control = control)
    list(fit = fit, deviance = REMLcrit(fit))
  })$fit
  table <- coef(summary(fit))
  print(summary(fit))
  keep_coefficients(model, table, setNames(table[, "df"], rownames(table)), "Pr(>|t|)",
                    if (unit == "degrees" && !absolute) identity else exp)
})

# Odds ratios. Variances by the restricted likelihood (Laplace's approximation of the integral over the coefficients
# too), coefficients by Laplace's approximation at these; t by Satterthwaite's degrees of freedom. glmer has the pieces.
binomial_fit <- function(formula, data) {
  parsed <- glFormula(formula, data, binomial)
  control <- glmerControl(tolPwrss = 1e-12)
  inner <- do.call(mkGlmerDevfun, c(parsed, list(control = control)))
  state <- environment(inner)
  restricted <- function(theta) inner(theta) + 2 * sum(log(diag(state$pp$RX())))
  best <- nlminb(parsed$reTrms$theta, restricted, lower = parsed$reTrms$lower, control = list(rel.tol = 1e-14))
  best <- nlminb(best$par, restricted, lower = parsed$reTrms$lower, control = list(rel.tol = 1e-14))
  list(parsed = parsed, inner = inner, state = state, restricted = restricted, theta = best$par,
       deviance = best$objective)
}
binomial_table <- function(fit) {
  state <- fit$state
  theta <- fit$theta
  covariance_at <- function(theta) {
    fit$inner(theta)
    chol2inv(state$pp$RX())
  }
  variances <- 2 * solve(numDeriv::hessian(fit$restricted, theta))
  gradients <- numDeriv::jacobian(function(theta) diag(covariance_at(theta)), theta)
  fit$inner(theta)
  beta <- state$pp$beta(1)
  outer <- updateGlmerDevfun(fit$inner, fit$parsed$reTrms)
  deviance_of <- function(beta) outer(c(theta, beta))
  beta <- nlminb(beta, deviance_of, control = list(rel.tol = 1e-14))$par
  errors <- sqrt(diag(2 * solve(numDeriv::hessian(deviance_of, beta))))
  degrees <- pmax(1, 2 * errors^4 / rowSums((gradients %*% variances) * gradients))
  table <- cbind(Estimate = beta, `Std. Error` = errors, df = degrees, p = 2 * pt(-abs(beta / errors), degrees))
  rownames(table) <- colnames(fit$parsed$X)
  table
}
binomial_model <- function(model, trials, terms, slopes) attempt(model, function() {
  data <- prepare(trials[!is.na(trials$correct), ], terms)
  if (length(slopes) == 0) {
    fit <- glm(formula_of("correct", terms, c()), binomial, data)
    print(summary(fit))
    table <- coef(summary(fit))
    return(keep_coefficients(model, table, setNames(rep(Inf, nrow(table)), rownames(table)), "Pr(>|z|)"))
  }
  # Each fit has a state of its own: the last one that was made is not the best one.
  fit <- fit_by_rule(data, slopes, function(random) binomial_fit(formula_of("correct", terms, random), data))
  table <- binomial_table(fit)
  print(table)
  keep_coefficients(model, table, setNames(table[, "df"], rownames(table)), "p")
})

# Covariances where trials of a subject are alike, and those of a case: Cameron, Gelbach and Miller 2011. What cases add
# counts where it is positive.
crossed_sum <- function(by_subject, by_case, by_both) {
  root <- t(chol(by_subject))
  parts <- eigen(solve(root, t(solve(root, by_case - by_both))), symmetric = TRUE)
  by_subject + root %*% parts$vectors %*% (pmax(parts$values, 0) * t(parts$vectors)) %*% t(root)
}
sums_of <- function(contributions, group) crossprod(rowsum(contributions, as.character(group)))
both_of <- function(subject, case) paste(subject, case, sep = "\r")
# Of what trials contribute (a row each), with factors for few clusters.
crossed_covariance <- function(contributions, subject, case, coefficients = ncol(contributions)) {
  factor_of <- function(group, taken) length(unique(group)) / max(1, length(unique(group)) - taken)
  by_subject <- factor_of(subject, 1) * sums_of(contributions, subject)
  if (is.null(case)) return(by_subject)
  crossed_sum(by_subject, factor_of(case, coefficients) * sums_of(contributions, case),
              sums_of(contributions, both_of(subject, case)))
}
# Of coefficients, by fitting again without one subject after the other, and one case. The report takes a single step of
# each search (Lipsitz, Dear and Zhao 1994), so that its errors differ a little.
jackknife_covariance <- function(coefficients, fit_without, influence, subject, case) {
  by <- function(group) {
    names <- unique(group)
    changes <- vapply(names, function(name) fit_without(group == name) - coefficients, coefficients)
    (length(names) - 1) / length(names) * tcrossprod(matrix(changes, nrow = length(coefficients)))
  }
  by_subject <- by(subject)
  few <- crossed_degrees(subject, case)
  if (is.null(case)) return(list(covariance = by_subject, degrees = rep(few, length(coefficients))))
  by_case <- by(case)
  covariance <- crossed_sum(by_subject, by_case, sums_of(influence, both_of(subject, case)))
  # Satterthwaite's, as of Clark's quasi F (1973), and those of the fewer of both at least.
  first <- length(unique(subject)) - 1
  degrees <- ifelse(diag(covariance) > diag(by_subject) * (1 + 1e-12),
                    diag(covariance)^2 / (diag(by_subject)^2 / first + diag(by_case)^2 / (length(unique(case)) - 1)), first)
  list(covariance = covariance, degrees = pmax(few, degrees))
}
crossed_degrees <- function(subject, case) {
  min(length(unique(subject)), if (!is.null(case)) length(unique(case))) - 1
}
keep_ratios <- function(model, estimates, covariance, degrees, skipped = c()) {
  for (term in setdiff(names(estimates), skipped)) {
    place <- match(term, names(estimates))
    error <- sqrt(diag(covariance))[[place]]
    half <- qt(0.975, degrees[[place]]) * error
    if (is.finite(half)) {
      keep(model, term, exp(estimates[[term]]), exp(estimates[[term]] - half), exp(estimates[[term]] + half),
           2 * pt(-abs(estimates[[term]] / error), degrees[[place]]))
    }
  }
}
# An estimate to which trials contribute values that sum up to 0.
keep_clustered <- function(model, term, estimate, contributions, subject, case, coefficients = 1) {
  error <- sqrt(crossed_covariance(cbind(contributions), subject, case, coefficients)[1, 1])
  degrees <- crossed_degrees(subject, case)
  half <- qt(0.975, degrees) * error
  keep(model, term, estimate, estimate - half, estimate + half, 2 * pt(-abs(estimate / error), degrees))
}
# Mean over the subjects who saw both views of their mean in @other@ less that in @reference@, and what each trial contributes to it.
view_difference <- function(data, values) {
  data <- data[!is.na(values), ]
  values <- values[!is.na(values)]
  counts <- table(data$subject_id, factor(data$view, c("@reference@", "@other@")))
  both <- data$subject_id %in% rownames(counts)[counts[, 1] > 0 & counts[, 2] > 0]
  data <- data[both, ]
  values <- values[both]
  subjects <- length(unique(data$subject_id))
  weights <- 1 / (counts[cbind(data$subject_id, data$view)] * subjects)
  means <- tapply(weights * values, data$view, sum)
  sign <- ifelse(data$view == "@other@", 1, -1)
  list(estimate = means[["@other@"]] - means[["@reference@"]], contributions = sign * weights * (values - means[data$view]),
       subject = data$subject_id, case = data$item)
}

# `timeouts`: "censored", "removed", "set_to_limit".
searches <- function(trials, timeouts, terms = "view") {
  data <- prepare(trials[!is.na(trials$response_s), ], terms)
  if (timeouts == "removed") data <- data[!(data$censored %in% 1), ]
  data$event <- if (timeouts == "set_to_limit") rep(1, nrow(data)) else 1 - (data$censored %in% 1)
  data
}
# Medians and restricted means. The report's errors of means are of subjects and cases as clusters; those here take
# trials as independent, and only the means are kept.
kaplan_meier <- function(model, trials, timeouts, limit) attempt(model, function() {
  data <- searches(trials, timeouts)
  data$name <- ifelse(data$view > 0, "@other@", "@reference@")
  fit <- survfit(Surv(response_s, event) ~ name, data)
  print(fit, rmean = limit)
  table <- summary(fit, rmean = limit)$table
  for (name in c("@reference@", "@other@")) {
    row <- table[paste0("name=", name), ]
    keep(model, paste(name, "median"), row[["median"]])
    keep(model, paste(name, "restricted mean"), row[[grep("rmean", names(row))[1]]])
  }
})
# `cases`: whether cases are clusters too, beside subjects.
cox_model <- function(model, trials, timeouts, terms, cases) attempt(model, function() {
  data <- searches(trials, timeouts, terms)
  formula <- as.formula(paste("Surv(response_s, event) ~", paste(terms, collapse = " + ")))
  fit <- coxph(formula, data, ties = "efron")
  print(summary(fit))
  case <- if (cases) data$case
  used <- !is.na(coef(fit))
  influence <- as.matrix(residuals(fit, type = "dfbeta"))[, used, drop = FALSE]
  without <- function(left_out) coef(coxph(formula, data[!left_out, ], ties = "efron"))[used]
  jackknife <- jackknife_covariance(coef(fit)[used], without, influence, data$subject, case)
  keep_ratios(model, coef(fit)[used], jackknife$covariance, jackknife$degrees)
})
log_normal_fit <- function(model, data, event, terms, cases, suffix = "") {
  varies <- vapply(terms, function(term) grepl(":", term, fixed = TRUE) || length(unique(data[[term]])) > 1, logical(1))
  data$event <- event
  formula <- as.formula(paste("Surv(response_s, event) ~", paste(c("1", terms[varies]), collapse = " + ")))
  fit <- survreg(formula, data, dist = "lognormal")
  print(summary(fit))
  case <- if (cases) data$case
  all_of <- function(fit) c(coef(fit), log(fit$scale))
  without <- function(left_out) all_of(survreg(formula, data[!left_out, ], dist = "lognormal"))
  influence <- as.matrix(residuals(fit, type = "dfbeta"))
  jackknife <- jackknife_covariance(all_of(fit), without, influence, data$subject, case)
  estimates <- setNames(coef(fit), paste0(names(coef(fit)), suffix))
  keep_ratios(model, estimates, jackknife$covariance, jackknife$degrees, paste0("(Intercept)", suffix))
}
log_normal_model <- function(model, trials, timeouts, terms, cases) attempt(model, function() {
  data <- searches(trials, timeouts, terms)
  log_normal_fit(model, data, data$event, terms, cases)
})

# Scenes of a subject's session that are alike but for the view, in the order in which they came.
mcnemar_model <- function(model, trials) attempt(model, function() {
  data <- trials[!is.na(trials$correct), ]
  data$kind <- paste(data$session_number, data$block, data$exposure_s, data$objects, data$duplicate_colors, sep = "/")
  data$scene <- paste(data$subject_id, data$kind, sep = "/")
  data$place <- ave(seq_len(nrow(data)), data$scene, data$view, FUN = seq_along)
  columns <- c("scene", "place", "correct", "subject_id", "kind")
  pairs <- merge(data[data$view == "@reference@", columns], data[data$view == "@other@", columns], by = c("scene", "place"),
                 suffixes = c("_@reference@", "_@other@"))
  only_@reference@ <- sum(pairs$correct_@reference@ == 1 & pairs$correct_@other@ == 0)
  only_@other@ <- sum(pairs$correct_@reference@ == 0 & pairs$correct_@other@ == 1)
  print(mcnemar.test(table(factor(pairs$correct_@reference@, 0:1), factor(pairs$correct_@other@, 0:1))))
  exact <- binom.test(only_@other@, only_@other@ + only_@reference@)
  odds <- function(share) share / (1 - share)
  differences <- pairs$correct_@other@ - pairs$correct_@reference@
  keep_clustered(model, "difference of shares, clustered", mean(differences),
                 (differences - mean(differences)) / nrow(pairs), pairs$subject_id_@reference@, pairs$kind_@reference@)
  keep(model, "difference of shares", (only_@other@ - only_@reference@) / nrow(pairs), p = exact$p.value)
  keep(model, "odds ratio", only_@other@ / only_@reference@, odds(exact$conf.int[1]), odds(exact$conf.int[2]), exact$p.value)
})

# One mean a view of each subject who saw both: @other@ less @reference@.
differences_of <- function(trials, values) {
  known <- !is.na(values)
  means <- tapply(values[known], list(trials$subject_id[known], factor(trials$view[known], c("@reference@", "@other@"))), mean)
  differences <- means[, "@other@"] - means[, "@reference@"]
  differences[!is.na(differences)]
}
# wilcox.test's pseudo-median of tied values solves an equation; the report has the median of all pairs' means.
signed_error_model <- function(model, trials) attempt(model, function() {
  errors <- suppressWarnings(as.numeric(trials$answer) - as.numeric(trials$expected))
  known <- !is.na(trials$correct)
  clustered <- view_difference(trials[known, ], errors[known])
  keep_clustered(model, "mean", clustered$estimate, clustered$contributions, clustered$subject, clustered$case, 2)
  differences <- differences_of(trials[known, ], errors[known])
  test <- suppressWarnings(wilcox.test(differences, conf.int = TRUE))
  print(test)
  pairs <- outer(differences, differences, "+") / 2
  keep(model, "center", median(pairs[lower.tri(pairs, diag = TRUE)]), p = test$p.value)
})

# Two one-sided t tests by hand.
equivalence_model <- function(model, trials, lower, upper, alpha) attempt(model, function() {
  shares <- view_difference(trials, trials$correct)
  error <- sqrt(crossed_covariance(cbind(shares$contributions), shares$subject, shares$case, 2)[1, 1])
  degrees <- crossed_degrees(shares$subject, shares$case)
  p <- max(pt((shares$estimate - lower) / error, degrees, lower.tail = FALSE),
           pt((shares$estimate - upper) / error, degrees))
  half <- qt(1 - alpha, degrees) * error
  keep(model, "difference of shares", shares$estimate, shares$estimate - half, shares$estimate + half, p)
})
# Jeffreys-Zellner-Siow with a medium scale (Rouder et al. 2009, equation 1), by hand, from the t with subjects and cases
# as clusters, as of a mean of as many numbers as there are of the fewer.
bayes_model <- function(model, trials, scale = sqrt(2) / 2) attempt(model, function() {
  shares <- view_difference(trials, trials$correct)
  error <- sqrt(crossed_covariance(cbind(shares$contributions), shares$subject, shares$case, 2)[1, 1])
  n <- crossed_degrees(shares$subject, shares$case) + 1
  t <- shares$estimate / error
  weight <- function(g) {
    spread <- 1 + n * g * scale^2
    spread^-0.5 * (1 + t^2 / (spread * (n - 1)))^(-n / 2) * (2 * pi)^-0.5 * g^-1.5 * exp(-1 / (2 * g))
  }
  effect <- integrate(weight, 0, Inf, rel.tol = 1e-9)$value / (1 + t^2 / (n - 1))^(-n / 2)
  keep(model, "for some, against none", effect)
})
chance_model <- function(model, trials, chance) attempt(model, function() {
  right <- trials$correct[!is.na(trials$correct)]
  test <- binom.test(sum(right), length(right), chance)
  print(test)
  keep(model, "both views", test$estimate, test$conf.int[1], test$conf.int[2], test$p.value)
})

# The last answer of each subject to each question that compares the views, as steps from the middle of its scale towards
# @other@. The p value of the model is the smallest, corrected for the number of questions.
ordinal_model <- function(model, answers) attempt(model, function() {
  answers <- answers[answers$form %in% "survey" & answers$last_favors %in% c("@reference@", "@other@"), ]
  answers <- answers[order(answers$session_number), ]
  answers <- answers[!duplicated(answers[c("field", "subject_id")], fromLast = TRUE), ]
  answers <- answers[!is.na(answers$option), ]
  answers$off <- (answers$option - (answers$options + 1) / 2) * ifelse(answers$last_favors == "@other@", 1, -1)
  p <- c()
  for (field in sort(unique(answers$field))) {
    off <- answers$off[answers$field == field]
    if (any(off != 0)) {
      test <- suppressWarnings(wilcox.test(off))
      keep(model, field, mean(off), p = test$p.value)
      p <- c(p, test$p.value)
    }
  }
  if (length(p) > 0) keep(model, "all questions", NA, p = min(p.adjust(p, "holm", n = length(unique(answers$field)))))
})

# p values of a family; each is of a model and a term, "" where the model has one test. Holm's method corrects for all
# `planned` hypotheses, also for those without a p value here.
family_of <- function(name, holm, planned, hypotheses, models, terms) {
  p <- mapply(function(model, term) {
    found <- results[results$model == model & (term == "" | results$term == term), ]
    if (model %in% unlist(results$model[results$term == "all questions"])) {
      found <- found[found$term == "all questions", ]
    }
    found$p[!is.na(found$p)][1]
  }, models, terms)
  cat("\nFamily", name, "\n")
  print(data.frame(hypothesis = hypotheses, p = p, adjusted = if (holm) p.adjust(p, "holm", n = planned) else p,
                   row.names = NULL))
}
)R";

}  // namespace ocelli
