# Makes golden.json: what R says about data that stand in the same file. R 4.2.2, survival 3.5-3, MASS 7.3-58, numDeriv, jsonlite.
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
clustered <- survfit(Surv(time, event) ~ 1, find, cluster = subject, robust = TRUE)
put("curve/clustered_error", summary(clustered, times = clustered$time)$std.err)
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

# Binomial, McNemar.
for (k in c(0, 12, 30)) {
  exact <- binom.test(k, 30, 1 / 3)
  above <- binom.test(k, 30, 1 / 3, alternative = "greater")
  score <- suppressWarnings(prop.test(k, 30, 1 / 3, correct = FALSE))
  put(paste0("binomial/", k), exact$estimate, exact$conf.int, exact$p.value, score$conf.int, score$statistic, score$p.value,
      above$p.value)
}
put("binomial/90", binom.test(7, 20, 1 / 3, conf.level = 0.9)$conf.int)
mcnemar <- function(both, first, second, neither) {
  table <- matrix(c(both, second, first, neither), 2)
  odds <- function(p) p / (1 - p)
  exact <- binom.test(second, first + second)
  n <- sum(table)
  p <- (first + 1) / (n + 2); q <- (second + 1) / (n + 2)
  width <- qnorm(0.975) * sqrt((p + q - (q - p)^2) / (n + 2))
  c(exact$p.value, exact$p.value - dbinom(min(first, second), first + second, 0.5),
    mcnemar.test(table, correct = FALSE)$statistic, mcnemar.test(table)$statistic,
    odds(exact$estimate), odds(exact$conf.int), (second - first) / n, q - p - width, q - p + width)
}
put("mcnemar/large", mcnemar(40, 6, 25, 19))
put("mcnemar/small", mcnemar(3, 1, 4, 2))

# Two samples, without and with ties.
set.seed(21)
first <- rnorm(14, 10, 2); second <- first + rnorm(14, 0.8, 1.5); other <- rnorm(11, 11, 3)
put("sample/first", first); put("sample/second", second); put("sample/other", other)
put("sample/rough_first", round(first)); put("sample/rough_second", round(second)); put("sample/rough_other", round(other))

# Equivalence.
tost <- function(d, se, df, lower, upper) {
  c(d, se, d + c(-1, 1) * qt(0.95, df) * se, pt((d - lower) / se, df, lower.tail = FALSE), pt((d - upper) / se, df))
}
d <- second - first
put("equivalence/paired", tost(mean(d), sd(d) / sqrt(14), 13, -2, 2))
put("equivalence/paired_t", t.test(d, mu = -2, alternative = "greater")$p.value, t.test(d, mu = 2, alternative = "less")$p.value)
welch <- t.test(other, first)
put("equivalence/welch", tost(mean(other) - mean(first), welch$stderr, welch$parameter, -1.5, 1.5), welch$parameter)
put("equivalence/welch_t", t.test(other, first, mu = -1.5, alternative = "greater")$p.value,
    t.test(other, first, mu = 1.5, alternative = "less")$p.value)
p <- 150 / 225; q <- 157 / 225
put("equivalence/shares", tost(q - p, sqrt(p * (1 - p) / 225 + q * (1 - q) / 225), Inf, -0.1, 0.1))
put("equivalence/paired_shares", tost((25 - 6) / 90, sqrt(31 - 19^2 / 90) / 90, Inf, -0.1, 0.1))

# Bayes factors: Rouder et al. 2009, eq. 1, by integrate() over g from 0 to 1 and from 1 to infinity.
jzs <- function(t, n, r) {
  v <- n - 1
  f <- function(g) (1 + n * g * r^2)^-0.5 * (1 + t^2 / ((1 + n * g * r^2) * v))^(-(v + 1) / 2) *
    (2 * pi)^-0.5 * g^-1.5 * exp(-1 / (2 * g))
  over <- function(a, b) integrate(f, a, b, rel.tol = 1e-12, subdivisions = 2000)$value
  log((over(0, 1) + over(1, 100) + over(100, Inf)) / (1 + t^2 / v)^(-(v + 1) / 2))
}
r <- sqrt(2) / 2
put("bayes/t", jzs(0, 10, r), jzs(0.7, 45, r), jzs(2.5, 20, r), jzs(-2.5, 20, 1), jzs(8, 45, r), jzs(1.2, 2, r), jzs(3, 2000, r))
put("bayes/paired", jzs(t.test(d)$statistic, 14, r))
share <- function(k, n, p, a, b) log(integrate(function(x) dbinom(k, n, x) * dbeta(x, a, b), 0, 1, rel.tol = 1e-12)$value / dbinom(k, n, p))
put("bayes/share", share(12, 30, 1 / 3, 1, 1), share(20, 30, 1 / 3, 1, 1), share(20, 30, 1 / 3, 2, 4))

# Wilcoxon.
signed <- function(x) { t <- suppressWarnings(wilcox.test(x, conf.int = TRUE)); c(t$statistic, t$p.value) }
location <- function(x) wilcox.test(x, conf.int = TRUE)
e <- location(d)
put("wilcoxon/signed", e$statistic, e$p.value, e$estimate, e$conf.int)
put("wilcoxon/signed_90", wilcox.test(d, conf.int = TRUE, conf.level = 0.9)$conf.int)
rough <- round(second) - round(first)
put("wilcoxon/signed_rough", signed(rough))
# Without ties but many: normal. The interval by order of the means of pairs.
set.seed(22); many <- rnorm(60, 0.3)
put("sample/many", many)
means <- outer(many, many, "+") / 2; means <- sort(means[upper.tri(means, TRUE)])
k <- floor(60 * 61 / 4 - qnorm(0.975) * sqrt(60 * 61 * 121 / 24))
put("wilcoxon/signed_many", signed(many), median(means), means[k], means[length(means) + 1 - k])
e <- wilcox.test(other, first, conf.int = TRUE)
put("wilcoxon/sum", e$statistic, e$p.value, e$estimate, e$conf.int)
e <- suppressWarnings(wilcox.test(round(other), round(first)))
put("wilcoxon/sum_rough", e$statistic, e$p.value)
e <- wilcox.test(many, c(first, other) - 10)
put("wilcoxon/sum_many", e$statistic, e$p.value)

# Holm.
p <- c(0.01, 0.04, 0.03, 0.005, 0.5, 0.04)
put("holm/p", p); put("holm/adjusted", p.adjust(p, "holm"))
put("holm/families", p.adjust(p[1:3], "holm"), p.adjust(p[4:6], "holm"))

# Effect sizes.
noncentral <- function(t, df, level) {
  f <- function(p) uniroot(function(ncp) pt(t, df, ncp) - p, c(t - 20, t + 20), tol = 1e-12)$root
  c(f((1 + level) / 2), f((1 - level) / 2))
}
hedges <- function(df) exp(lgamma(df / 2) - lgamma((df - 1) / 2)) * sqrt(2 / df)
t <- t.test(d)$statistic
units <- sd(d) / ((sd(first) + sd(second)) / 2)
put("effect/paired", t / sqrt(14), noncentral(t, 13, 0.95) / sqrt(14), t / sqrt(14) * units, t / sqrt(14) * hedges(13),
    t / sqrt(14) * units * hedges(13))
t <- t.test(other, first, var.equal = TRUE)$statistic
root <- sqrt(14 * 11 / 25)
put("effect/groups", t / root, noncentral(t, 23, 0.95) / root, t / root * hedges(23))
model <- function(link) {
  data <- data.frame(y = c(30, 12), n = c(45, 40), x = c(1, 0))
  glm(cbind(y, n - y) ~ x, binomial(link), data, control = glm.control(epsilon = 1e-14, maxit = 100), start = c(-0.8, 0.2))
}
ratio <- function(fit) { b <- coef(summary(fit))["x", ]; exp(b[1] + c(0, -1, 1) * qnorm(0.975) * b[2]) }
put("effect/odds", ratio(model("logit"))); put("effect/risk", ratio(model("log")))
a <- prop.test(12, 40, correct = FALSE); b <- prop.test(30, 45, correct = FALSE)
difference <- b$estimate - a$estimate
put("effect/difference", difference, difference - sqrt((b$estimate - b$conf.int[1])^2 + (a$conf.int[2] - a$estimate)^2),
    difference + sqrt((b$conf.int[2] - b$estimate)^2 + (a$estimate - a$conf.int[1])^2))
cliff <- function(x, y) {
  s <- sign(outer(y, x, "-")); m <- length(y); n <- length(x); delta <- mean(s)
  v <- (n^2 * sum((rowMeans(s) - delta)^2) + m^2 * sum((colMeans(s) - delta)^2) - sum((s - delta)^2)) / (m * n * (m - 1) * (n - 1))
  v <- max(v, (1 - delta^2) / (m * n - 1)); z <- qnorm(0.975)
  c(delta, sqrt(v), (delta - delta^3 + c(-1, 1) * z * sqrt(v) * sqrt((1 - delta^2)^2 + z^2 * v)) / (1 - delta^2 + z^2 * v))
}
put("effect/cliff", cliff(first, other)); put("effect/cliff_rough", cliff(round(first), round(other)))
w <- location(d)$statistic
biserial <- 2 * w / 105 - 1
put("effect/biserial", biserial, tanh(atanh(biserial) + c(-1, 1) * qnorm(0.975) * sqrt(14 * 15 * 29 / 6) / 105))

# Means.
student <- function(t, estimate) c(estimate, t$conf.int, t$statistic, t$parameter, t$p.value)
put("student/mean", student(t.test(first), mean(first)))
put("student/mean80", student(t.test(first, conf.level = 0.8), mean(first)))
put("student/welch", student(t.test(other, first), mean(other) - mean(first)))

# Proportional odds.
set.seed(23)
odds <- data.frame(x = rep(0:1, each = 30), age = rnorm(60, 25, 4))
odds$y <- findInterval(0.8 * odds$x + 0.1 * (odds$age - 25) + rlogis(60), c(-1.5, -0.5, 0.5, 1.5)) + 1
for (column in names(odds)) put(paste0("odds/", column), odds[[column]])
polr0 <- polr(factor(y) ~ x + age, odds, Hess = TRUE)
deviance2 <- function(b) {
  at <- c(-Inf, b[3:6], Inf); eta <- b[1] * odds$x + b[2] * odds$age
  -sum(log(plogis(at[odds$y + 1] - eta) - plogis(at[odds$y] - eta)))
}
best <- c(coef(polr0), polr0$zeta)
for (i in 1:20) best <- best - solve(numDeriv::hessian(deviance2, best), numDeriv::grad(deviance2, best))
stopifnot(max(abs(best - c(coef(polr0), polr0$zeta))) < 1e-3)
put("odds/coefficients", best); put("odds/errors", sqrt(diag(solve(numDeriv::hessian(deviance2, best)))))
null <- polr(factor(y) ~ 1, odds)
put("odds/likelihood", -deviance2(best), as.numeric(logLik(null)))

# BCa, from given values: Efron and Tibshirani (14.9) to (14.15), quantiles of type 6.
values <- qgamma(ppoints(999), 3); influences <- (sort(first) - mean(first)) / 14
z0 <- qnorm(mean(values < 2.8)); a <- sum(influences^3) / (6 * sum(influences^2)^1.5)
ends <- z0 + qnorm(c(0.025, 0.975))
put("bca/values", values); put("bca/influences", influences)
put("bca/interval", quantile(values, pnorm(z0 + ends / (1 - a * ends)), type = 6))

writeLines(jsonlite::toJSON(golden, digits = I(17), na = "null"), commandArgs(TRUE)[1])
