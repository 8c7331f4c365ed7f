# Makes golden.json: what R says about data that stand in the same file. R 4.2.2, survival 3.5-3, MASS 7.3-58, jsonlite.
# Usage: Rscript golden.R golden.json
suppressMessages({library(survival); library(MASS)})
golden <- list()
put <- function(name, ...) golden[[name]] <<- as.numeric(c(...))

# Data. lung and veteran come with survival. The find data are made: 20 subjects see 6 cases in both views, up to 60 s.
lung <- lung[complete.cases(lung[, c("time", "status", "age", "sex", "ph.ecog", "inst")]), ]
lung$event <- lung$status - 1
for (column in c("time", "event", "age", "sex", "ph.ecog", "inst")) put(paste0("lung/", column), lung[[column]])
veteran$type <- as.integer(veteran$celltype)
for (column in c("time", "status", "trt", "karno", "type")) put(paste0("veteran/", column), veteran[[column]])
set.seed(20)
find <- expand.grid(view = 0:1, case = 1:6, subject = 1:20)
logtime <- 2.8 - 0.35 * find$view + rnorm(20, 0, 0.3)[find$subject] + rnorm(6, 0, 0.4)[find$case] + rnorm(nrow(find), 0, 0.6)
find$time <- pmin(round(exp(logtime), 0), 60)
find$event <- as.numeric(exp(logtime) < 60)
for (column in names(find)) put(paste0("find/", column), find[[column]])

# Kaplan-Meier.
curve <- survfit(Surv(time, event) ~ 1, lung, conf.type = "log-log")
put("curve/time", curve$time); put("curve/risk", curve$n.risk); put("curve/events", curve$n.event)
put("curve/survival", curve$surv); put("curve/error", summary(curve, times = curve$time)$std.err)
put("curve/lower", curve$lower); put("curve/upper", curve$upper)
medians <- function(fit) { q <- quantile(fit, 0.5); c(q$quantile, q$lower, q$upper) }
put("median/lung", medians(curve))
# 6 of 12 end before a long gap: the curve stays at a half.
flat <- data.frame(time = c(1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15), event = c(rep(1, 11), 0))
put("median/flat", medians(survfit(Surv(time, event) ~ 1, flat, conf.type = "log-log")))
few <- data.frame(time = c(1, 2, 3, 4, 5, 6, 7, 8), event = c(1, 1, 0, 1, 1, 0, 0, 0))
put("median/few", medians(survfit(Surv(time, event) ~ 1, few, conf.type = "log-log")))

# Restricted means.
rmean <- function(fit, horizon) survival:::survmean(fit, rmean = horizon)$matrix[c("rmean", "se(rmean)")]
put("rmean/lung500", rmean(curve, 500))
for (view in 0:1) {
  rows <- find$view == view
  put(paste0("rmean/find", view), rmean(survfit(Surv(time, event) ~ 1, find[rows, ]), 60))
}
# By cluster: residuals of the area under the curve, summed.
influence <- numeric(nrow(find)); means <- numeric(2)
for (view in 0:1) {
  rows <- find$view == view
  fit <- survfit(Surv(time, event) ~ 1, find[rows, ])
  influence[rows] <- (2 * view - 1) * residuals(fit, times = 60, type = "auc")
  means[view + 1] <- rmean(fit, 60)[1]
}
sums <- tapply(influence, find$subject, sum)
put("rmean/clustered", diff(means), sqrt(sum(sums^2) * 20 / 19))

# Log-rank.
logrank <- function(test) c(test$chisq, length(test$n) - 1)
test <- survdiff(Surv(time, event) ~ sex, lung)
put("logrank/lung", logrank(test)); put("logrank/lung_expected", test$exp)
put("logrank/veteran", logrank(survdiff(Surv(time, status) ~ type, veteran)))
put("logrank/strata", logrank(survdiff(Surv(time, status) ~ trt + strata(type), veteran)))

# Cox.
tight <- coxph.control(eps = 1e-13, toler.chol = 1e-15, iter.max = 100)
cox <- function(name, fit) {
  put(paste0(name, "/coefficients"), coef(fit))
  put(paste0(name, "/errors"), sqrt(diag(fit$var)))
  put(paste0(name, "/covariance"), fit$var)
  if (!is.null(fit$naive.var)) put(paste0(name, "/model_errors"), sqrt(diag(fit$naive.var)))
  put(paste0(name, "/likelihood"), fit$loglik)
  put(paste0(name, "/tests"), summary(fit)$logtest["test"], fit$wald.test)
  for (scale in c("km", "identity")) {
    z <- cox.zph(fit, transform = scale, terms = FALSE)$table
    put(paste0(name, "/zph_", scale), z[, "chisq"])
  }
}
cox("cox/lung", coxph(Surv(time, event) ~ age + sex + ph.ecog, lung, control = tight))
cox("cox/lung_clustered", coxph(Surv(time, event) ~ age + sex + ph.ecog, lung, cluster = inst, control = tight))
cox("cox/veteran_strata", coxph(Surv(time, status) ~ trt + karno + strata(type), veteran, control = tight))
cox("cox/find", coxph(Surv(time, event) ~ view, find, cluster = subject, control = tight))
cox("cox/find_strata", coxph(Surv(time, event) ~ view + strata(case), find, cluster = subject, control = tight))

# Log-normal.
exact <- survreg.control(rel.tolerance = 1e-13, maxiter = 100)
aft <- function(name, fit) {
  put(paste0(name, "/coefficients"), coef(fit), log(fit$scale))
  put(paste0(name, "/errors"), sqrt(diag(fit$var)))
  put(paste0(name, "/covariance"), fit$var)
  if (!is.null(fit$naive.var)) put(paste0(name, "/model_errors"), sqrt(diag(fit$naive.var)))
  put(paste0(name, "/likelihood"), fit$loglik[length(fit$loglik)])
}
aft("aft/lung", survreg(Surv(time, event) ~ age + sex + ph.ecog, lung, dist = "lognormal", control = exact))
aft("aft/lung_clustered", survreg(Surv(time, event) ~ age + sex + ph.ecog, lung, cluster = inst, dist = "lognormal", control = exact))
aft("aft/find", survreg(Surv(time, event) ~ view, find, cluster = subject, dist = "lognormal", control = exact))
aft("aft/intercept", survreg(Surv(time, event) ~ 1, find, dist = "lognormal", control = exact))

writeLines(jsonlite::toJSON(golden, digits = I(17), na = "null"), commandArgs(TRUE)[1])
