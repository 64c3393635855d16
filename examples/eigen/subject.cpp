// Eigen's rotations as a subject of affinecert: a request a line on stdin, an answer a line on stdout. See README.md.
#include <Eigen/Geometry>
#include <iostream>
#include <map>
#include <string>
#include <vector>
using namespace Eigen;

using Input = std::vector<double>;  // the numbers of a map's arguments, one after the other, matrices row by row

MatrixXd so3_exp(const Input& x) {
    Vector3d omega(x.data());
    return AngleAxisd(omega.stableNorm(), omega.stableNormalized()).toRotationMatrix();
}

MatrixXd so3_log(const Input& x) {
    Matrix3d rotation = Map<const Matrix<double, 3, 3, RowMajor>>(x.data());
    if (!rotation.isUnitary(1e-6) || rotation.determinant() < 0) return {};  // no numbers: refused
    AngleAxisd turn(rotation);
    return turn.angle() * turn.axis().transpose();  // a result of one row is a vector
}

MatrixXd slerp(const Input& x) {
    Quaterniond start(x[0], x[1], x[2], x[3]), end(x[4], x[5], x[6], x[7]);
    if (std::abs(start.norm() - 1) > 1e-6 || std::abs(end.norm() - 1) > 1e-6) return {};
    Quaterniond between = start.normalized().slerp(x[8], end.normalized());
    return RowVector4d(between.w(), between.x(), between.y(), between.z());
}

std::map<std::string, MatrixXd (*)(const Input&)> maps = {
    {"so3.exp", so3_exp}, {"so3.log", so3_log}, {"quaternion.slerp", slerp}};

#ifdef MATRIX_FUNCTIONS
#include "matrix_functions.h"
#endif

void hello() {
    std::cout << R"({"name": "eigen", "version": ")" << EIGEN_WORLD_VERSION << "." << EIGEN_MAJOR_VERSION << "."
              << EIGEN_MINOR_VERSION << R"(", "maps": [)";
    for (auto& map : maps) std::cout << (&map == &*maps.begin() ? "\"" : ", \"") << map.first << "\"";
}

void print(const MatrixXd& y) {
    bool flat = y.rows() == 1;
    IOFormat json(StreamPrecision, DontAlignCols, "\", \"", ", ", "[\"", "\"]", flat ? "[" : "[[", flat ? "]" : "]]");
    y.size() ? std::cout << std::hexfloat << y.format(json) : std::cout << "null";
}

void answer(const std::string& line) {  // {"map": "so3.exp", "inputs": [[["0x0p+0", "0x0p+0", "0x0p+0"]], ...]}
    size_t name = line.find("\"map\": \"") + 8, depth = 0;
    auto map = maps.at(line.substr(name, line.find('"', name) - name));
    Input x;
    std::cout << R"({"outputs": [)";
    for (const char *text = &line[line.find('[')], *separator = ""; *text; text++) {
        if (*text == '[') depth++;
        if (*text == '"') x.push_back(std::strtod(text + 1, const_cast<char**>(&text)));
        if (*text != ']' || depth-- != 2) continue;  // an input is a list at depth 2; here it ends
        std::cout << separator, print(map(x)), x.clear(), separator = ", ";
    }
}

int main() {
    for (std::string line; std::getline(std::cin, line); std::cout << "]}" << std::endl)
        line.find("\"hello\"") != line.npos ? hello() : answer(line);
}
