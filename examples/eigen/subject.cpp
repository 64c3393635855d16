// Eigen's rotations as a subject of affinecert: a request a line on stdin, an answer a line on stdout. See README.md.
#include <Eigen/Geometry>
#include <cstdio>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>
using namespace Eigen;

using Input = std::vector<double>;  // the numbers of a map's arguments, one after the other, matrices row by row
using Maps = std::map<std::string, MatrixXd (*)(const Input&)>;

Maps maps = {
    {"so3.exp", [](const Input& x) -> MatrixXd {
         Vector3d omega(x.data());
         return AngleAxisd(omega.stableNorm(), omega.stableNormalized()).toRotationMatrix();
     }},
    {"so3.log", [](const Input& x) -> MatrixXd {
         Matrix3d rotation = Map<const Matrix<double, 3, 3, RowMajor>>(x.data());
         if (!rotation.isUnitary(1e-6) || rotation.determinant() < 0) throw std::domain_error("not a rotation");
         AngleAxisd turn(rotation);
         return turn.angle() * turn.axis();
     }},
    {"quaternion.slerp", [](const Input& x) -> MatrixXd {
         Quaterniond start(x[0], x[1], x[2], x[3]), end(x[4], x[5], x[6], x[7]);
         if (std::abs(start.norm() - 1) > 1e-6 || std::abs(end.norm() - 1) > 1e-6) throw std::domain_error("not units");
         Quaterniond between = start.normalized().slerp(x[8], end.normalized());
         return Vector4d(between.w(), between.x(), between.y(), between.z());
     }},
};

#ifdef MATRIX_FUNCTIONS
#include "matrix_functions.h"
#endif

void print(const MatrixXd& result) {  // a column is a vector, anything else a list of rows
    for (int i = 0; i < result.rows(); i++) {
        std::printf(i ? ", " : "[");
        for (int k = 0; k < result.cols(); k++)
            std::printf("%s\"%a\"", k ? ", " : result.cols() > 1 ? "[" : "", result(i, k));
        if (result.cols() > 1) std::printf("]");
    }
    std::printf("]");
}

void answer(MatrixXd (*map)(const Input&), const char* text) {
    Input x;
    const char* separator = "";
    for (int depth = 0; *text != '}'; text++) {  // an input is a list at depth 2, its arguments are deeper
        if (*text == '[') depth++;
        if (*text == '"') x.push_back(std::strtod(text + 1, const_cast<char**>(&text)));
        if (*text != ']' || depth-- != 2) continue;
        std::printf("%s", separator);
        try {
            MatrixXd result = map(x);
            std::printf("[");
            print(result);
            std::printf("]");
        } catch (const std::domain_error&) {
            std::printf("null");
        }
        x.clear();
        separator = ", ";
    }
}

int main() {
    for (std::string line; std::getline(std::cin, line); std::fflush(stdout)) {
        if (line.find("\"hello\"") != line.npos) {
            std::printf("{\"name\": \"eigen\", \"version\": \"%d.%d.%d\", \"maps\": ", EIGEN_WORLD_VERSION,
                        EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
            for (auto& map : maps) std::printf("%s\"%s\"", &map == &*maps.begin() ? "[" : ", ", map.first.c_str());
            std::printf("]}\n");
        } else {
            size_t name = line.find("\"map\": \"") + 8, inputs = line.find("\"inputs\": ") + 10;
            std::printf("{\"outputs\": [");
            answer(maps.at(line.substr(name, line.find('"', name) - name)), &line[inputs]);
            std::printf("]}\n");
        }
    }
}
