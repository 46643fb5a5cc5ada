#include "fem/parallel/network_solver.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>

namespace asperity::fem {
namespace {

/// @throws std::runtime_error  hypre reports a failure
void check(HYPRE_Int code, const char* what) {
  if (code != 0 && !HYPRE_CheckError(code, HYPRE_ERROR_CONV)) {
    HYPRE_ClearAllErrors();
    throw std::runtime_error(std::string("hypre could not ") + what);
  }
}

class NetworkMatrix {
public:
  explicit NetworkMatrix(const flow::Network& network) {
    const auto n = static_cast<HYPRE_Int>(network.size());
    std::vector<HYPRE_Int> rows(network.size()), sizes = network.row_sizes;
    std::iota(rows.begin(), rows.end(), 0);
    check(HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, n - 1, 0, n - 1, &matrix_),
          "make a matrix");
    HYPRE_IJMatrixSetObjectType(matrix_, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(matrix_, sizes.data());
    HYPRE_IJMatrixInitialize(matrix_);
    check(HYPRE_IJMatrixSetValues(matrix_, n, sizes.data(), rows.data(),
                                  network.columns.data(),
                                  network.values.data()),
          "fill a matrix");
    check(HYPRE_IJMatrixAssemble(matrix_), "assemble a matrix");
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(matrix_, &object);
    values_ = static_cast<HYPRE_ParCSRMatrix>(object);
  }

  NetworkMatrix(const NetworkMatrix&) = delete;
  NetworkMatrix& operator=(const NetworkMatrix&) = delete;

  ~NetworkMatrix() { HYPRE_IJMatrixDestroy(matrix_); }

  HYPRE_ParCSRMatrix get() const { return values_; }

private:
  HYPRE_IJMatrix matrix_ = nullptr;
  HYPRE_ParCSRMatrix values_ = nullptr;
};

class NetworkVector {
public:
  explicit NetworkVector(const std::vector<double>& numbers)
      : size_(static_cast<HYPRE_Int>(numbers.size())) {
    check(HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, size_ - 1, &vector_),
          "make a vector");
    HYPRE_IJVectorSetObjectType(vector_, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(vector_);
    HYPRE_IJVectorSetValues(vector_, size_, nullptr, numbers.data());
    check(HYPRE_IJVectorAssemble(vector_), "assemble a vector");
    void* object = nullptr;
    HYPRE_IJVectorGetObject(vector_, &object);
    values_ = static_cast<HYPRE_ParVector>(object);
  }

  NetworkVector(const NetworkVector&) = delete;
  NetworkVector& operator=(const NetworkVector&) = delete;

  ~NetworkVector() { HYPRE_IJVectorDestroy(vector_); }

  HYPRE_ParVector get() const { return values_; }

  std::vector<double> numbers() const {
    std::vector<HYPRE_Int> rows(static_cast<std::size_t>(size_));
    std::iota(rows.begin(), rows.end(), 0);
    std::vector<double> result(rows.size());
    HYPRE_IJVectorGetValues(vector_, size_, rows.data(), result.data());
    return result;
  }

private:
  HYPRE_Int size_;
  HYPRE_IJVector vector_ = nullptr;
  HYPRE_ParVector values_ = nullptr;
};

/// Conjugate gradients with one V-cycle of algebraic multigrid as
/// preconditioner.
class NetworkIteration {
public:
  NetworkIteration() {
    HYPRE_BoomerAMGCreate(&multigrid_);
    HYPRE_BoomerAMGSetMaxIter(multigrid_, 1);
    HYPRE_BoomerAMGSetTol(multigrid_, 0.0);
    HYPRE_BoomerAMGSetCoarsenType(multigrid_, 3); // Ruge-Stueben
    HYPRE_BoomerAMGSetInterpType(multigrid_, 0);  // classical
    HYPRE_BoomerAMGSetPMaxElmts(multigrid_, 4);   // of a row
    HYPRE_BoomerAMGSetRelaxType(multigrid_, 8);   // symmetric Gauss-Seidel
    HYPRE_BoomerAMGSetStrongThreshold(multigrid_, 0.25); // for two dimensions
    HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &gradients_);
    HYPRE_PCGSetMaxIter(gradients_, 200);
    HYPRE_PCGSetTol(gradients_, 1e-8);
    HYPRE_PCGSetTwoNorm(gradients_, 0);
    HYPRE_PCGSetPrecond(
        gradients_,
        reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSolve),
        reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSetup),
        multigrid_);
  }

  NetworkIteration(const NetworkIteration&) = delete;
  NetworkIteration& operator=(const NetworkIteration&) = delete;

  ~NetworkIteration() {
    HYPRE_ParCSRPCGDestroy(gradients_);
    HYPRE_BoomerAMGDestroy(multigrid_);
  }

  flow::NetworkSolution solve(const flow::Network& network) {
    const NetworkMatrix matrix(network);
    const NetworkVector right_side(network.right_side);
    const NetworkVector potential(network.start);
    check(HYPRE_ParCSRPCGSetup(gradients_, matrix.get(), right_side.get(),
                               potential.get()),
          "set up multigrid");
    check(HYPRE_ParCSRPCGSolve(gradients_, matrix.get(), right_side.get(),
                               potential.get()),
          "solve a network");
    HYPRE_ClearAllErrors();
    flow::NetworkSolution solution{potential.numbers()};
    HYPRE_PCGGetNumIterations(gradients_, &solution.iterations);
    HYPRE_Int converged = 0;
    HYPRE_PCGGetConverged(gradients_, &converged);
    solution.converged = converged != 0;
    return solution;
  }

private:
  HYPRE_Solver multigrid_ = nullptr, gradients_ = nullptr;
};

} // namespace

flow::NetworkSolution solved_network(const flow::Network& network) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  static const int initialised = HYPRE_Init();
  check(initialised, "start");
  return NetworkIteration().solve(network);
}

} // namespace asperity::fem
