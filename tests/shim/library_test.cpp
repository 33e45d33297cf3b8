// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// libGLARK.so as a file: its dependencies and its exports.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cctype>
#include <sstream>
#include <string>

#include "tests/shim/process.h"

namespace glark::test {

TEST(Library, NeedsNoGlAndNoCxxLibrary) {
  const Outcome needed = run("readelf -d " GLARK_LIBRARY " | grep NEEDED");
  ASSERT_NE(needed.output.find("libc.so"), std::string::npos) << needed.output;
  for (const char* name : {"libGL", "libEGL", "libOSMesa", "libOpenGL", "libX11", "libstdc++", "libgcc_s"})
    EXPECT_EQ(needed.output.find(name), std::string::npos) << needed.output;
}

TEST(Library, ExportsOnlyWhatItInterposes) {
  std::istringstream names(run("nm -D --defined-only " GLARK_LIBRARY " | awk '{print $NF}'").output);
  int count = 0;
  for (std::string name; names >> name; ++count) {
    const bool linker = name == "dlsym" || name == "dlvsym" || name == "dlopen";
    const bool gl =
        name.starts_with("gl") && name.size() > 2 && (std::isupper(static_cast<unsigned char>(name[2])) != 0);
    const bool egl =
        name.starts_with("egl") && name.size() > 3 && (std::isupper(static_cast<unsigned char>(name[3])) != 0);
    EXPECT_TRUE(linker || gl || egl || name.starts_with("OSMesa")) << name;
  }
  EXPECT_GT(count, 800);
}

TEST(Library, ThreadStateIsInitialExec) {
  // The wrappers' own thread-local state is reached without a call: a general-dynamic access would need this relocation
  // for it.
  const Outcome outcome = run("readelf -rW " GLARK_LIBRARY " | grep -c TPOFF");
  EXPECT_GT(std::stoi(outcome.output), 0);
}

// A future registry has a draw that nobody has classed.
TEST(Generator, AnUnclassedDrawFailsTheBuild) {
  const std::string folder = testing::TempDir() + "generate" + std::to_string(getpid());
  run("mkdir -p " + folder +
      "; sed 's#<commands namespace=\"GL\">#&<command><proto>void "
      "<name>glDrawNewThingEXT</name></proto></command>#' " GLARK_GL_XML " > " +
      folder + "/gl.xml");
  const Outcome outcome = run("python3 " GENERATOR "/generate.py " + folder + " " GENERATOR "/classes.txt " + folder +
                              "/gl.xml " GENERATOR "/glark.xml");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.output.find("functions that look like draws have no class: glDrawNewThingEXT"), std::string::npos)
      << outcome.output;
}

}  // namespace glark::test
