// Functions of homogeneous matrices, by the unsupported module of Eigen; part of subject.cpp, but slow to compile.
#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

MatrixXd square(const Input& x, int size) { return Map<const Matrix<double, -1, -1, RowMajor>>(x.data(), size, size); }

MatrixXd affine(const Input& x) {  // of the plane or of space; log and pow want "no eigenvalues which are real and negative"
    MatrixXd matrix = square(x, x.size() < 16 ? 3 : 4);
    long n = matrix.rows() - 1;
    if (matrix.row(n) != MatrixXd::Identity(n + 1, n + 1).row(n)) throw std::domain_error("not affine");
    for (auto value : matrix.topLeftCorner(n, n).eigenvalues())
        if (value.imag() == 0 && value.real() <= 0) throw std::domain_error("no real logarithm");
    return matrix;
}

const bool added = [] {
    maps["se3.exp"] = [](const Input& x) -> MatrixXd {
        Matrix4d twist;
        twist << 0, -x[2], x[1], x[3], x[2], 0, -x[0], x[4], -x[1], x[0], 0, x[5], 0, 0, 0, 0;
        return twist.exp();
    };
    maps["sam.log"] = [](const Input& x) -> MatrixXd { return affine(x).log(); };
    maps["sam.power"] = [](const Input& x) -> MatrixXd { return affine(x).pow(x.back()); };
    return true;
}();
