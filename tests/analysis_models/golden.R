# Writes golden.json: data sets and what lme4 and lmerTest say of them. The data are teaching sets of lme4, or made here by
# seed. Optimisers run until nothing moves, so that the values hold to more digits than the defaults give.
#
# Usage: Rscript golden.R golden.json (R 4.2, lme4 1.1-31, lmerTest 3.1-3, numDeriv, jsonlite)
library(lme4)
library(lmerTest)
library(jsonlite)

linear <- lmerControl(optimizer = "bobyqa", optCtrl = list(rhoend = 1e-10, maxfun = 1e5), calc.derivs = FALSE)
binomial_control <- glmerControl(optimizer = "bobyqa", optCtrl = list(rhoend = 1e-9, maxfun = 1e5), calc.derivs = FALSE,
                                 tolPwrss = 1e-12)

# Levels in the order of their names' bytes.
first_effects <- function(model) {
  effects <- ranef(model)[[1]]
  effects[order(rownames(effects), method = "radix"), 1]
}

random_parts <- function(model) {
  correlations <- lapply(VarCorr(model), function(v) unname(attr(v, "correlation")))
  deviations <- lapply(VarCorr(model), function(v) unname(attr(v, "stddev")))
  list(groups = names(VarCorr(model)), deviations = unname(deviations), correlations = unname(correlations))
}

of_linear <- function(formula, data, restricted) {
  model <- lmerTest::lmer(formula, data, REML = restricted, control = linear)
  rows <- coef(summary(model))
  criterion <- if (restricted) REMLcrit(model) else deviance(model)
  c(list(restricted = restricted, criterion = criterion, names = rownames(rows), coefficients = unname(fixef(model)),
         standardErrors = unname(rows[, "Std. Error"]), df = unname(rows[, "df"]), p = unname(rows[, "Pr(>|t|)"]),
         sigma = sigma(model), theta = unname(getME(model, "theta")), singular = isSingular(model),
         firstEffects = first_effects(model), fitted = unname(head(fitted(model), 10))), random_parts(model))
}

# Standard errors from a Hessian by Richardson extrapolation: that of glmer itself is coarser. With several points glmer
# leaves the likelihood of the saturated model out.
of_binomial <- function(formula, data, points = 1) {
  model <- glmer(formula, data, family = binomial, nAGQ = points, control = binomial_control)
  theta <- getME(model, "theta")
  criterion <- glmer(formula, data, family = binomial, nAGQ = points, control = binomial_control, devFunOnly = TRUE)
  hessian <- numDeriv::hessian(criterion, c(theta, fixef(model)))
  covariance <- 2 * solve(hessian)
  fixed <- seq_along(fixef(model)) + length(theta)
  trials <- weights(model)
  saturated <- -2 * sum(dbinom(round(getME(model, "y") * trials), trials, getME(model, "y"), log = TRUE))
  value <- -2 * c(logLik(model)) + if (points > 1) saturated else 0
  c(list(points = points, minusTwoLogLikelihood = value, names = names(fixef(model)),
         coefficients = unname(fixef(model)), standardErrors = sqrt(diag(covariance))[fixed], theta = unname(theta),
         firstEffects = first_effects(model)), random_parts(model))
}

columns <- function(data) lapply(as.list(data), function(x) if (is.factor(x)) as.character(x) else x)

# Subjects, each with 12 items in two sessions; each item in one of the views; view, moving and session are coded -0.5 and 0.5.
find_like <- function(seed, subjects, items) {
  set.seed(seed)
  data <- expand.grid(item = 1:items, session = c(-0.5, 0.5), subject = 1:subjects)
  data$view <- ((data$item + data$subject + (data$session > 0)) %% 2) - 0.5
  data$moving <- (data$item > items / 2) - 0.5
  intercepts <- rnorm(subjects, 0, 0.3)
  slopes <- 0.4 * intercepts + rnorm(subjects, 0, 0.15)
  effects <- rnorm(items, 0, 0.4)
  mean <- 2.6 - 0.45 * data$view + 0.3 * data$moving - 0.1 * data$session + 0.2 * data$view * data$moving
  data$y <- round(mean + intercepts[data$subject] + slopes[data$subject] * data$view + effects[data$item] +
                    rnorm(nrow(data), 0, 0.5), 4)
  data[runif(nrow(data)) < 0.9, ]
}

count_like <- function(seed, subjects, items) {
  set.seed(seed)
  data <- expand.grid(item = 1:items, subject = 1:subjects)
  data$view <- ((data$item + data$subject) %% 2) - 0.5
  data$duration <- (data$item %% 3) / 2 - 0.5
  intercepts <- rnorm(subjects, 0, 0.8)
  slopes <- -0.2 * intercepts + rnorm(subjects, 0, 0.5)
  effects <- rnorm(items, 0, 0.6)
  mean <- 0.4 + 1.5 * data$view + 0.7 * data$duration
  probability <- plogis(mean + intercepts[data$subject] + slopes[data$subject] * data$view + effects[data$item])
  data$y <- rbinom(nrow(data), 1, probability)
  data
}

text_levels <- function(data, names) {
  for (name in names) data[[name]] <- factor(sprintf("%03d", data[[name]]))
  data
}

find_data <- text_levels(find_like(7, 30, 12), c("item", "subject"))
count_data <- text_levels(count_like(11, 40, 20), c("item", "subject"))
pastes <- transform(Pastes, sample = factor(sample))
find_model <- y ~ view * moving + session + (1 + view | subject) + (1 | item)

golden <- list(
  dyestuff = list(data = columns(Dyestuff), ml = of_linear(Yield ~ 1 + (1 | Batch), Dyestuff, FALSE),
                  reml = of_linear(Yield ~ 1 + (1 | Batch), Dyestuff, TRUE)),
  # The variance between batches is 0 here.
  dyestuff2 = list(data = columns(Dyestuff2), ml = of_linear(Yield ~ 1 + (1 | Batch), Dyestuff2, FALSE)),
  sleepstudy = list(data = columns(sleepstudy),
                    ml = of_linear(Reaction ~ Days + (Days | Subject), sleepstudy, FALSE),
                    reml = of_linear(Reaction ~ Days + (Days | Subject), sleepstudy, TRUE),
                    uncorrelated = of_linear(Reaction ~ Days + (Days || Subject), sleepstudy, TRUE)),
  penicillin = list(data = columns(Penicillin),
                    ml = of_linear(diameter ~ 1 + (1 | plate) + (1 | sample), Penicillin, FALSE),
                    reml = of_linear(diameter ~ 1 + (1 | plate) + (1 | sample), Penicillin, TRUE)),
  pastes = list(data = columns(pastes), reml = of_linear(strength ~ 1 + (1 | sample) + (1 | batch), pastes, TRUE)),
  find = list(data = columns(find_data), ml = of_linear(find_model, find_data, FALSE),
              reml = of_linear(find_model, find_data, TRUE)),
  cbpp = list(data = columns(cbpp),
              laplace = of_binomial(cbind(incidence, size - incidence) ~ period + (1 | herd), cbpp),
              quadrature9 = of_binomial(cbind(incidence, size - incidence) ~ period + (1 | herd), cbpp, 9),
              quadrature25 = of_binomial(cbind(incidence, size - incidence) ~ period + (1 | herd), cbpp, 25)),
  count = list(data = columns(count_data),
               laplace = of_binomial(y ~ view + duration + (1 + view | subject) + (1 | item), count_data),
               subjects = of_binomial(y ~ view + duration + (1 | subject), count_data, 9))
)
golden$find$likelihoodRatio <- {
  smaller <- lme4::lmer(update(find_model, . ~ . - view:moving), find_data, REML = FALSE, control = linear)
  larger <- lme4::lmer(find_model, find_data, REML = FALSE, control = linear)
  table <- anova(smaller, larger)
  list(statistic = table$Chisq[2], df = table$Df[2], p = table[["Pr(>Chisq)"]][2])
}
write(toJSON(golden, digits = NA, auto_unbox = TRUE), commandArgs(trailingOnly = TRUE)[1])
