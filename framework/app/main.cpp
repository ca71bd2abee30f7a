// The `ashlar` program: read the command line, do what it asks for, tell how it ended.

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include "app/interrupt.hpp"
#include "app/verbs.hpp"
#include "core/error.hpp"

namespace {

using namespace ashlar;

int act(const app::CommandLine& line) {
  if (line.verb == "version") return std::cout << "ashlar " ASHLAR_VERSION "\n", app::done;
  if (line.verb == "run") return app::run(line);
  if (line.verb == "check") return app::check(line);
  if (line.verb == "plan") return app::plan(line);
  if (line.verb == "study") return app::study(line);
  if (line.verb == "drive") return app::drive(line);
  if (line.verb == "list") return app::list(line);
  if (line.verb == "describe") return app::describe(line);
  return std::cout << app::help_text(), app::done;
}

int tell(const core::InputError& error) {
  for (const core::Mistake& mistake : error.mistakes()) std::cerr << core::to_string(mistake) << '\n';
  if (error.mistakes().size() > 1) std::cerr << error.mistakes().size() << " mistakes\n";
  return app::input_mistake;
}

int tell_our_fault(const char* what) {
  std::cerr << "This is our fault, not yours: " << what
            << "\nNo results were written. Please send us the scene and this message.\n";
  return app::our_fault;
}

}  // namespace

int main(int count, char** words) {
  // Numerical libraries that start threads of their own as they are opened hang at exit where memory is short
  // (OpenBLAS 0.3.21), and those threads would never be used: loops over cells are the parallel ones.
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  app::watch_for_interrupts();
  try {
    return act(app::read_command_line({words, static_cast<std::size_t>(count)}));
  } catch (const app::Interrupted&) {
    std::cerr << "Stopped by Ctrl-C. Earlier results are untouched.\n";
    return app::interrupted;
  } catch (const core::InputError& error) {
    const int code = tell(error);
    return app::was_interrupted() ? app::interrupted : code;
  } catch (const std::bad_alloc&) {
    std::cerr << "The machine has not enough memory for this. No results were written.\n"
                 "A coarser mesh needs less; `ashlar plan` tells the number of unknowns.\n";
    return app::our_fault;
  } catch (const std::exception& error) {
    return tell_our_fault(error.what());
  } catch (...) {
    return tell_our_fault("an error of an unknown kind");
  }
}
