#include "engine/application.h"

int main(int argc, char** argv) {
    return engine::run_application(argc, argv);
}
