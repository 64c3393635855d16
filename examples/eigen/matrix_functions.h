// Functions of homogeneous matrices, by the unsupported module of Eigen; part of subject.cpp, but slow to compile.
#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

// Nothing where log and pow want "no eigenvalues which are real and negative", or where the matrix is not affine.
MatrixXd affine(const Input& x) {
    long n = x.size() < 16 ? 2 : 3;
    MatrixXd matrix = Map<const Matrix<double, -1, -1, RowMajor>>(x.data(), n + 1, n + 1);
    if (matrix.row(n) != MatrixXd::Identity(n + 1, n + 1).row(n)) return {};
    for (auto value : matrix.topLeftCorner(n, n).eigenvalues())
        if (value.imag() == 0 && value.real() <= 0) return {};
    return matrix;
}

const bool added = [] {
    maps["se3.exp"] = [](const Input& x) -> MatrixXd {
        Matrix4d twist;
        twist << 0, -x[2], x[1], x[3], x[2], 0, -x[0], x[4], -x[1], x[0], 0, x[5], 0, 0, 0, 0;
        return twist.exp();
    };
    maps["sam.log"] = [](const Input& x) -> MatrixXd {
        MatrixXd matrix = affine(x);
        return matrix.size() ? matrix.log() : matrix;
    };
    maps["sam.power"] = [](const Input& x) -> MatrixXd {
        MatrixXd matrix = affine(x);
        return matrix.size() ? matrix.pow(x.back()) : matrix;
    };
    return true;
}();
