#pragma once
// Least squares over several runs: parameters shared by all runs, and nuisance parameters of one
// run (where it began). Residuals within a run are correlated, so the scatter between runs, not the
// number of residuals, determines how well a parameter is known.

#include <Eigen/Core>
#include <vector>

namespace tp100::identify {

/// Huber's weight and cost of a residual, in standard deviations.
double huber_weight(double deviations);
double huber_cost(double deviations);

/// How many consecutive residuals are worth one: their correlation, summed up to its end.
double samples_together(const std::vector<double>& residuals);

/// Sums of one run: shared parameters first, own ones eliminated.
class RunSums {
 public:
  using Derivatives = Eigen::Ref<const Eigen::VectorXd>;

  RunSums(Eigen::Index shared, Eigen::Index own);
  /// One residual (measured - predicted) with the derivatives of the prediction.
  void add(const Derivatives& by_shared, const Derivatives& by_own, double residual, double weight);
  /// Call after the last residual.
  void eliminate();

  const Eigen::MatrixXd& information() const { return information_; }  ///< of the shared ones
  const Eigen::VectorXd& score() const { return score_; }
  /// Step of the run's own parameters for a step of the shared ones.
  Eigen::VectorXd own_step(const Eigen::VectorXd& shared_step) const;

 private:
  Eigen::MatrixXd information_, cross_, own_information_, own_inverse_;
  Eigen::VectorXd score_, own_score_;
};

/// What is known of the shared parameters without any run.
struct PriorSums {
  Eigen::MatrixXd information;
  Eigen::VectorXd score;
};

/// All runs combined: the shared parameters, with the prior's information.
class Summed {
 public:
  Summed(const std::vector<RunSums>& runs, const PriorSums& prior);

  Eigen::VectorXd step(double damping) const;
  /// Covariance if every weight were the inverse of an independent variance.
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Condition of the information scaled to a unit diagonal.
  double condition() const;

 private:
  Eigen::MatrixXd information_, covariance_;
  Eigen::VectorXd score_;
};

/// How well the shared parameters are known. No model is exact: each run has values of its own,
/// which differ from the common ones by more than noise. By how much, in units of a given error of
/// each parameter, is estimated from the contradictions between the runs (a random effect of each
/// run, by restricted maximum likelihood).
class Intervals {
 public:
  /// `unit`: of each parameter; 0 if it is the same in every run.
  Intervals(const std::vector<RunSums>& runs, const PriorSums& prior, Eigen::VectorXd unit);

  /// Half widths of 95 % intervals, which hold what another run would find without noise.
  Eigen::VectorXd half() const;
  /// What these would be divided by with one more run.
  Eigen::VectorXd narrowed_by(const RunSums& run) const;

 private:
  Eigen::MatrixXd spread(double between) const;

  Eigen::VectorXd unit_;
  double between_ = 0.0;
  Eigen::MatrixXd covariance_;
};

}  // namespace tp100::identify
