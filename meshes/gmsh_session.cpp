#include "meshes/gmsh_session.hpp"

#include <gmsh.h>

#include <mutex>
#include <stdexcept>
#include <string>

namespace asperity::meshes {
namespace {

/// Initialises gmsh and finalises it on destruction.
class Session {
public:
  Session() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
  }

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  ~Session() { gmsh::finalize(); }
};

[[noreturn]] void refuse(const std::string& words) {
  throw std::domain_error("gmsh: " + words);
}

} // namespace

void in_gmsh(const std::function<void()>& work) {
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const Session session;
  // gmsh throws its message as a string; newer versions throw an exception.
  try {
    work();
  } catch (const std::string& words) {
    refuse(words);
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  } catch (int) {
    std::string words;
    gmsh::logger::getLastError(words);
    refuse(words);
  }
}

} // namespace asperity::meshes
