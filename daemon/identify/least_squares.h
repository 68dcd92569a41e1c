#pragma once
// Least squares over several runs: parameters shared by all runs, and nuisance parameters of one
// run (where it began). Residuals within a run are correlated, so the scatter between runs, not the
// number of residuals, determines how well a parameter is known.

#include <Eigen/Core>
#include <vector>

namespace tp100::identify {

/// Sums of one run: shared parameters first, own ones eliminated.
class RunSums {
 public:
  RunSums(Eigen::Index shared, Eigen::Index own);
  /// One residual (measured - predicted) with the derivatives of the prediction.
  void add(const Eigen::VectorXd& by_shared, const Eigen::VectorXd& by_own, double residual,
           double weight);
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

/// All runs combined: the shared parameters, with the prior's information.
class Summed {
 public:
  /// `prior_information` and `prior_score` of the same size as the runs'.
  Summed(const std::vector<RunSums>& runs, const Eigen::MatrixXd& prior_information,
         const Eigen::VectorXd& prior_score);

  Eigen::VectorXd step(double damping) const;
  /// Covariance if every weight were the inverse of an independent variance.
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Half widths of 95 % intervals, the wider of two: from the weights, and from the contradictions
  /// between runs (clustered by run, each run's score scaled up as if it had been left out;
  /// Student's t with as many degrees of freedom as runs that really inform the parameter).
  Eigen::VectorXd half_intervals() const;
  /// Condition of the information scaled to a unit diagonal.
  double condition() const;

 private:
  const std::vector<RunSums>& runs_;
  Eigen::MatrixXd information_, covariance_;
  Eigen::VectorXd score_;
};

}  // namespace tp100::identify
