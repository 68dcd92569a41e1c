#include "identify/least_squares.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "core/statistics.h"

namespace tp100::identify {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Lu = Eigen::PartialPivLU<MatrixXd>;

// Eigen's templates for products and solutions are compiled once here, not once per expression
// below: that takes half of the time.
MatrixXd product(const MatrixXd& a, const MatrixXd& b) { return a * b; }
VectorXd product(const MatrixXd& a, const VectorXd& b) { return a * b; }
MatrixXd solve(const Lu& a, const MatrixXd& b) { return a.solve(b); }
VectorXd solve(const Lu& a, const VectorXd& b) { return a.solve(b); }
MatrixXd inverse(const MatrixXd& a) { return Lu(a).inverse(); }
MatrixXd identity(Eigen::Index size) { return MatrixXd::Identity(size, size); }
void add_outer_product(MatrixXd& sum, double weight, const RunSums::Derivatives& a,
                       const RunSums::Derivatives& b) {
  for (Eigen::Index column = 0; column < b.size(); ++column)
    for (Eigen::Index row = 0; row < a.size(); ++row)
      sum(row, column) += weight * a[row] * b[column];
}

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
    : information_(MatrixXd::Zero(shared, shared)),
      cross_(MatrixXd::Zero(shared, own)),
      own_information_(MatrixXd::Zero(own, own)),
      own_inverse_(own, own),
      score_(VectorXd::Zero(shared)),
      own_score_(VectorXd::Zero(own)) {}

void RunSums::add(const Derivatives& by_shared, const Derivatives& by_own, double residual,
                  double weight) {
  add_outer_product(information_, weight, by_shared, by_shared);
  add_outer_product(cross_, weight, by_shared, by_own);
  add_outer_product(own_information_, weight, by_own, by_own);
  score_ += weight * residual * by_shared;
  own_score_ += weight * residual * by_own;
}

void RunSums::eliminate() {
  // An own parameter without any information stays where it is.
  for (Eigen::Index i = 0; i < own_information_.rows(); ++i)
    if (own_information_(i, i) == 0.0) own_information_(i, i) = 1.0;
  own_inverse_ = inverse(own_information_);
  const MatrixXd by_own = product(cross_, own_inverse_);
  information_ -= product(by_own, MatrixXd(cross_.transpose()));
  score_ -= product(by_own, own_score_);
}

VectorXd RunSums::own_step(const VectorXd& shared_step) const {
  return product(own_inverse_,
                 VectorXd(own_score_ - product(MatrixXd(cross_.transpose()), shared_step)));
}

Summed::Summed(const std::vector<RunSums>& runs, const PriorSums& prior)
    : information_(prior.information), score_(prior.score) {
  for (const RunSums& run : runs) {
    information_ += run.information();
    score_ += run.score();
  }
  covariance_ = inverse(information_);
}

VectorXd Summed::step(double damping) const {
  MatrixXd damped = information_;
  damped.diagonal() *= 1.0 + damping;
  return solve(Lu(damped), score_);
}

double Summed::condition() const {
  const VectorXd scale = information_.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * information_ * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  // Of the Jacobian, not of its square.
  return std::sqrt(solver.eigenvalues().maxCoeff() /
                   std::max(solver.eigenvalues().minCoeff(), 1e-16));
}

namespace {

/// With runs whose values differ from the common ones.
struct Candidate {
  MatrixXd covariance;
  double deviance;  // -2 log of the restricted likelihood, but for a constant
};

Candidate with_spread(const std::vector<RunSums>& runs, const PriorSums& prior,
                      const MatrixXd& spread) {
  MatrixXd information = prior.information;
  VectorXd score = prior.score;
  double deviance = 0.0;
  for (const RunSums& run : runs) {
    const Lu scaled(identity(spread.rows()) + product(run.information(), spread));
    const VectorXd own = solve(scaled, run.score());
    information += solve(scaled, run.information());
    score += own;
    deviance += std::log(std::abs(scaled.determinant())) - run.score().dot(product(spread, own));
  }
  const Lu all(information);
  deviance += std::log(std::abs(all.determinant())) - score.dot(solve(all, score));
  return {all.inverse(), deviance};
}

}  // namespace

Intervals::Intervals(const std::vector<RunSums>& runs, const PriorSums& prior, VectorXd unit)
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

MatrixXd Intervals::spread(double between) const {
  return (between * unit_).array().square().matrix().asDiagonal();
}

VectorXd Intervals::half() const {
  return kNormal95 * (covariance_ + spread(between_)).diagonal().array().sqrt();
}

VectorXd Intervals::narrowed_by(const RunSums& run) const {
  const MatrixXd unit = identity(covariance_.rows());
  const MatrixXd of_runs = spread(between_);
  const MatrixXd information =
      solve(Lu(unit + product(run.information(), of_runs)), run.information());
  const MatrixXd after = solve(Lu(unit + product(covariance_, information)), covariance_);
  return ((covariance_ + of_runs).diagonal().array() / (after + of_runs).diagonal().array()).sqrt();
}

}  // namespace tp100::identify
