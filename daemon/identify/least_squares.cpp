#include "identify/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "core/statistics.h"

namespace tp100::identify {
namespace {

constexpr double kTail = 0.025;

// Where the standard deviation between runs is looked for, in units.
constexpr double kLeastBetween = 0.02, kMaxBetween = 8.0, kBetweenStep = 1.15;
constexpr double kHuber = 2.0;  // standard deviations

}  // namespace

double huber_weight(double deviations) { return deviations <= kHuber ? 1.0 : kHuber / deviations; }
double huber_cost(double deviations) {
  return deviations <= kHuber ? deviations * deviations : kHuber * (2.0 * deviations - kHuber);
}

double samples_together(const std::vector<double>& residuals) {
  const std::size_t n = residuals.size();
  double squares = 0.0;
  for (const double residual : residuals) squares += residual * residual;
  double together = 1.0;
  for (std::size_t lag = 1; lag < n / 2 && squares > 0.0; ++lag) {
    double products = 0.0;
    for (std::size_t i = lag; i < n; ++i) products += residuals[i] * residuals[i - lag];
    if (products <= 0.0) break;
    together += 2.0 * products / squares;
  }
  return together;
}

RunSums::RunSums(Eigen::Index shared, Eigen::Index own)
    : information_(Eigen::MatrixXd::Zero(shared, shared)),
      cross_(Eigen::MatrixXd::Zero(shared, own)),
      own_information_(Eigen::MatrixXd::Zero(own, own)),
      own_inverse_(own, own),
      score_(Eigen::VectorXd::Zero(shared)),
      own_score_(Eigen::VectorXd::Zero(own)) {}

void RunSums::add(const Eigen::VectorXd& by_shared, const Eigen::VectorXd& by_own, double residual,
                  double weight) {
  information_.noalias() += weight * by_shared * by_shared.transpose();
  cross_.noalias() += weight * by_shared * by_own.transpose();
  own_information_.noalias() += weight * by_own * by_own.transpose();
  score_ += weight * residual * by_shared;
  own_score_ += weight * residual * by_own;
}

void RunSums::eliminate() {
  // An own parameter without any information stays where it is.
  for (Eigen::Index i = 0; i < own_information_.rows(); ++i)
    if (own_information_(i, i) == 0.0) own_information_(i, i) = 1.0;
  own_inverse_ = own_information_.inverse();
  information_ -= cross_ * own_inverse_ * cross_.transpose();
  score_ -= cross_ * own_inverse_ * own_score_;
}

Eigen::VectorXd RunSums::own_step(const Eigen::VectorXd& shared_step) const {
  return own_inverse_ * (own_score_ - cross_.transpose() * shared_step);
}

Summed::Summed(const std::vector<RunSums>& runs, const PriorSums& prior)
    : runs_(runs), information_(prior.information), score_(prior.score) {
  for (const RunSums& run : runs) {
    information_ += run.information();
    score_ += run.score();
  }
  covariance_ = information_.inverse();
}

Eigen::VectorXd Summed::step(double damping) const {
  Eigen::MatrixXd damped = information_;
  damped.diagonal() *= 1.0 + damping;
  return damped.ldlt().solve(score_);
}

Eigen::VectorXd Summed::half_intervals() const {
  const Eigen::Index size = score_.size();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(size, size);
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(size);
  for (const RunSums& run : runs_) {
    const Eigen::MatrixXd others = identity - run.information() * covariance_;
    const Eigen::VectorXd score = others.partialPivLu().solve(run.score());
    scatter += score * score.transpose();
    const Eigen::MatrixXd by_run = covariance_ * run.information() * covariance_;
    for (Eigen::Index i = 0; i < size; ++i) shares[i] += square(by_run(i, i) / covariance_(i, i));
  }
  const Eigen::MatrixXd clustered = covariance_ * scatter * covariance_;
  Eigen::VectorXd half(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    half[i] = kNormal95 * std::sqrt(covariance_(i, i));
    const double runs = shares[i] > 0.0 ? 1.0 / shares[i] : 1.0;
    if (runs_.size() < 2 || runs < 1.5 || !std::isfinite(clustered(i, i))) continue;
    const double student = student_t(kTail, std::max(1.0, runs - 1.0));
    half[i] = std::max(half[i], student * std::sqrt(clustered(i, i)));
  }
  return half;
}

double Summed::condition() const {
  const Eigen::VectorXd scale = information_.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information_ * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  // Of the Jacobian, not of its square.
  return std::sqrt(solver.eigenvalues().maxCoeff() /
                   std::max(solver.eigenvalues().minCoeff(), 1e-16));
}

namespace {

/// With runs whose values differ from the common ones.
struct Candidate {
  Eigen::MatrixXd covariance;
  double deviance;  // -2 log of the restricted likelihood, but for a constant
};

Candidate with_spread(const std::vector<RunSums>& runs, const PriorSums& prior,
                      const Eigen::MatrixXd& spread) {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(spread.rows(), spread.cols());
  Eigen::MatrixXd information = prior.information;
  Eigen::VectorXd score = prior.score;
  double deviance = 0.0;
  for (const RunSums& run : runs) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> scaled(identity + run.information() * spread);
    const Eigen::VectorXd own = scaled.solve(run.score());
    information += scaled.solve(run.information());
    score += own;
    deviance += std::log(std::abs(scaled.determinant())) - run.score().dot(spread * own);
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> all(information);
  deviance += std::log(std::abs(all.determinant())) - score.dot(all.solve(score));
  return {all.inverse(), deviance};
}

}  // namespace

Intervals::Intervals(const std::vector<RunSums>& runs, const PriorSums& prior, Eigen::VectorXd unit)
    : unit_(std::move(unit)) {
  Candidate best = with_spread(runs, prior, spread(0.0));
  for (double sd = kLeastBetween; runs.size() > 1 && sd < kMaxBetween; sd *= kBetweenStep) {
    Candidate other = with_spread(runs, prior, spread(sd));
    if (other.deviance >= best.deviance) continue;
    best = std::move(other);
    between_ = sd;
  }
  covariance_ = std::move(best.covariance);
}

Eigen::MatrixXd Intervals::spread(double between) const {
  return (between * unit_).array().square().matrix().asDiagonal();
}

Eigen::VectorXd Intervals::half() const {
  return kNormal95 * (covariance_ + spread(between_)).diagonal().array().sqrt();
}

Eigen::VectorXd Intervals::narrowed_by(const RunSums& run) const {
  const Eigen::MatrixXd identity =
      Eigen::MatrixXd::Identity(covariance_.rows(), covariance_.cols());
  const Eigen::MatrixXd of_runs = spread(between_);
  const Eigen::MatrixXd information =
      (identity + run.information() * of_runs).partialPivLu().solve(run.information());
  const Eigen::MatrixXd after =
      (identity + covariance_ * information).partialPivLu().solve(covariance_);
  return ((covariance_ + of_runs).diagonal().array() / (after + of_runs).diagonal().array()).sqrt();
}

}  // namespace tp100::identify
