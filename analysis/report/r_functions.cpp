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
                               view = ifelse(values == "gc", 0.5, -0.5),
                               moving = ,
                               duplicates = values - 0.5,
                               values - mean(values))
  }
  prepared
}
formula_of <- function(response, terms, random) {
  as.formula(paste(response, "~", paste(c("1", terms, random), collapse = " + ")))
}

keep_coefficients <- function(model, table, degrees, p) {
  for (term in setdiff(rownames(table), "(Intercept)")) {
    half <- qt(0.975, degrees[[term]]) * table[term, "Std. Error"]
    estimate <- table[term, "Estimate"]
    keep(model, term, exp(estimate), exp(estimate - half), exp(estimate + half), table[term, p])
  }
}

# Ratios of geometric means; restricted likelihood, Satterthwaite's degrees of freedom.
linear_model <- function(model, trials, timeouts_removed, terms, random) attempt(model, function() {
  data <- prepare(trials[!is.na(trials$response_s) & trials$response_s > 0, ], terms)
  if (timeouts_removed) data <- data[!(data$censored %in% 1), ]
  formula <- formula_of("log(response_s)", terms, random)
  if (length(random) == 0) {
    fit <- lm(formula, data)
    table <- coef(summary(fit))
    degrees <- setNames(rep(fit$df.residual, nrow(table)), rownames(table))
  } else {
    fit <- lmerTest::lmer(formula, data, control = lmerControl(optCtrl = list(xtol_abs = 1e-10, ftol_abs = 1e-12)))
    table <- coef(summary(fit))
    degrees <- setNames(table[, "df"], rownames(table))
  }
  print(summary(fit))
  keep_coefficients(model, table, degrees, "Pr(>|t|)")
})

# Odds ratios. Variances by the restricted likelihood (Laplace's approximation of the integral over the coefficients
# too), coefficients by Laplace's approximation at these; t by Satterthwaite's degrees of freedom. glmer has the pieces.
binomial_model <- function(model, trials, terms, random) attempt(model, function() {
  data <- prepare(trials[!is.na(trials$correct), ], terms)
  formula <- formula_of("correct", terms, random)
  if (length(random) == 0) {
    fit <- glm(formula, binomial, data)
    print(summary(fit))
    table <- coef(summary(fit))
    return(keep_coefficients(model, table, setNames(rep(Inf, nrow(table)), rownames(table)), "Pr(>|z|)"))
  }
  parsed <- glFormula(formula, data, binomial)
  control <- glmerControl(tolPwrss = 1e-12)
  inner <- do.call(mkGlmerDevfun, c(parsed, list(control = control)))
  state <- environment(inner)
  restricted <- function(theta) inner(theta) + 2 * sum(log(diag(state$pp$RX())))
  covariance_at <- function(theta) {
    inner(theta)
    chol2inv(state$pp$RX())
  }
  best <- nlminb(parsed$reTrms$theta, restricted, lower = parsed$reTrms$lower, control = list(rel.tol = 1e-14))
  theta <- nlminb(best$par, restricted, lower = parsed$reTrms$lower, control = list(rel.tol = 1e-14))$par
  variances <- 2 * solve(numDeriv::hessian(restricted, theta))
  gradients <- numDeriv::jacobian(function(theta) diag(covariance_at(theta)), theta)
  inner(theta)
  beta <- state$pp$beta(1)
  outer <- updateGlmerDevfun(inner, parsed$reTrms)
  deviance_of <- function(beta) outer(c(theta, beta))
  beta <- nlminb(beta, deviance_of, control = list(rel.tol = 1e-14))$par
  errors <- sqrt(diag(2 * solve(numDeriv::hessian(deviance_of, beta))))
  degrees <- 2 * errors^4 / rowSums((gradients %*% variances) * gradients)
  names <- colnames(parsed$X)
  table <- cbind(Estimate = beta, `Std. Error` = errors, p = 2 * pt(-abs(beta / errors), degrees))
  rownames(table) <- names
  print(cbind(table, df = degrees))
  keep_coefficients(model, table, setNames(degrees, names), "p")
})

# Errors of what trials contribute (a row each), where trials of a subject are alike, and those of a case: Cameron,
# Gelbach and Miller 2011, with factors for few clusters. What cases add counts where it is positive.
crossed_covariance <- function(contributions, subject, case, coefficients = ncol(contributions)) {
  by <- function(group) crossprod(rowsum(contributions, as.character(group)))
  factor_of <- function(group, taken) length(unique(group)) / max(1, length(unique(group)) - taken)
  by_subject <- factor_of(subject, 1) * by(subject)
  if (is.null(case)) return(by_subject)
  root <- t(chol(by_subject))
  added <- factor_of(case, coefficients) * by(case) - by(paste(subject, case, sep = "\r"))
  parts <- eigen(solve(root, t(solve(root, added))), symmetric = TRUE)
  by_subject + root %*% parts$vectors %*% (pmax(parts$values, 0) * t(parts$vectors)) %*% t(root)
}
crossed_degrees <- function(subject, case) {
  min(length(unique(subject)), if (!is.null(case)) length(unique(case))) - 1
}
keep_ratios <- function(model, estimates, covariance, degrees, skipped = c()) {
  for (term in setdiff(names(estimates), skipped)) {
    error <- sqrt(diag(covariance))[[match(term, names(estimates))]]
    half <- qt(0.975, degrees) * error
    if (is.finite(half)) {
      keep(model, term, exp(estimates[[term]]), exp(estimates[[term]] - half), exp(estimates[[term]] + half),
           2 * pt(-abs(estimates[[term]] / error), degrees))
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
# Mean over the subjects who saw both views of their mean in gc less that in ppc, and what each trial contributes to it.
view_difference <- function(data, values) {
  data <- data[!is.na(values), ]
  values <- values[!is.na(values)]
  counts <- table(data$subject_id, factor(data$view, c("ppc", "gc")))
  both <- data$subject_id %in% rownames(counts)[counts[, 1] > 0 & counts[, 2] > 0]
  data <- data[both, ]
  values <- values[both]
  subjects <- length(unique(data$subject_id))
  weights <- 1 / (counts[cbind(data$subject_id, data$view)] * subjects)
  means <- tapply(weights * values, data$view, sum)
  sign <- ifelse(data$view == "gc", 1, -1)
  list(estimate = means[["gc"]] - means[["ppc"]], contributions = sign * weights * (values - means[data$view]),
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
  data$name <- ifelse(data$view > 0, "gc", "ppc")
  fit <- survfit(Surv(response_s, event) ~ name, data)
  print(fit, rmean = limit)
  table <- summary(fit, rmean = limit)$table
  for (name in c("ppc", "gc")) {
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
  keep_ratios(model, coef(fit)[used], crossed_covariance(influence, data$subject, case),
              crossed_degrees(data$subject, case))
})
log_normal_model <- function(model, trials, timeouts, terms, cases) attempt(model, function() {
  data <- searches(trials, timeouts, terms)
  varies <- vapply(terms, function(term) grepl(":", term, fixed = TRUE) || length(unique(data[[term]])) > 1, logical(1))
  formula <- as.formula(paste("Surv(response_s, event) ~", paste(c("1", terms[varies]), collapse = " + ")))
  fit <- survreg(formula, data, dist = "lognormal")
  print(summary(fit))
  case <- if (cases) data$case
  keep_ratios(model, coef(fit), crossed_covariance(as.matrix(residuals(fit, type = "dfbeta")), data$subject, case),
              crossed_degrees(data$subject, case), "(Intercept)")
})

# Scenes of a subject's session that are alike but for the view, in the order in which they came.
mcnemar_model <- function(model, trials) attempt(model, function() {
  data <- trials[!is.na(trials$correct), ]
  data$kind <- paste(data$session_number, data$block, data$exposure_s, data$objects, data$duplicate_colors, sep = "/")
  data$scene <- paste(data$subject_id, data$kind, sep = "/")
  data$place <- ave(seq_len(nrow(data)), data$scene, data$view, FUN = seq_along)
  columns <- c("scene", "place", "correct", "subject_id", "kind")
  pairs <- merge(data[data$view == "ppc", columns], data[data$view == "gc", columns], by = c("scene", "place"),
                 suffixes = c("_ppc", "_gc"))
  only_ppc <- sum(pairs$correct_ppc == 1 & pairs$correct_gc == 0)
  only_gc <- sum(pairs$correct_ppc == 0 & pairs$correct_gc == 1)
  print(mcnemar.test(table(factor(pairs$correct_ppc, 0:1), factor(pairs$correct_gc, 0:1))))
  exact <- binom.test(only_gc, only_gc + only_ppc)
  odds <- function(share) share / (1 - share)
  differences <- pairs$correct_gc - pairs$correct_ppc
  keep_clustered(model, "difference of shares, clustered", mean(differences),
                 (differences - mean(differences)) / nrow(pairs), pairs$subject_id_ppc, pairs$kind_ppc)
  keep(model, "difference of shares", (only_gc - only_ppc) / nrow(pairs), p = exact$p.value)
  keep(model, "odds ratio", only_gc / only_ppc, odds(exact$conf.int[1]), odds(exact$conf.int[2]), exact$p.value)
})

# One mean a view of each subject who saw both: gc less ppc.
differences_of <- function(trials, values) {
  known <- !is.na(values)
  means <- tapply(values[known], list(trials$subject_id[known], factor(trials$view[known], c("ppc", "gc"))), mean)
  differences <- means[, "gc"] - means[, "ppc"]
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
# Jeffreys-Zellner-Siow with a medium scale (Rouder et al. 2009, equation 1), by hand.
bayes_model <- function(model, trials, scale = sqrt(2) / 2) attempt(model, function() {
  differences <- differences_of(trials, trials$correct)
  n <- length(differences)
  t <- mean(differences) / (sd(differences) / sqrt(n))
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

# The last answer of each subject to each question, against the middle of the scale. The p value of the model is the
# smallest, corrected for the number of questions.
ordinal_model <- function(model, answers) attempt(model, function() {
  answers <- answers[answers$form %in% "survey", ]
  answers$number <- suppressWarnings(as.numeric(answers$answer))
  answers <- answers[answers$number %in% 1:5, ]
  answers <- answers[order(answers$session_number), ]
  answers <- answers[!duplicated(answers[c("field", "subject_id")], fromLast = TRUE), ]
  p <- c()
  for (field in sort(unique(answers$field))) {
    off <- answers$number[answers$field == field] - 3
    if (any(off != 0)) {
      test <- suppressWarnings(wilcox.test(off))
      keep(model, field, mean(off) + 3, p = test$p.value)
      p <- c(p, test$p.value)
    }
  }
  if (length(p) > 0) keep(model, "all questions", NA, p = min(p.adjust(p, "holm")))
})

# p values of a family; each is of a model and a term, "" where the model has one test.
family_of <- function(name, holm, hypotheses, models, terms) {
  p <- mapply(function(model, term) {
    found <- results[results$model == model & (term == "" | results$term == term), ]
    if (model %in% unlist(results$model[results$term == "all questions"])) {
      found <- found[found$term == "all questions", ]
    }
    found$p[!is.na(found$p)][1]
  }, models, terms)
  cat("\nFamily", name, "\n")
  print(data.frame(hypothesis = hypotheses, p = p, adjusted = if (holm) p.adjust(p, "holm") else p, row.names = NULL))
}
)R";

}  // namespace ocelli
