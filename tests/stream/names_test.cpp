// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Names that no file can have.
#include <climits>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using Names = TemporaryFolder;

// Returns the message of the Error, and expects its element.
template <class Step>
std::string problem_of_element(Element element, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    EXPECT_EQ(error.element(), element) << error.what();
    return error.what();
  }
  return "no error";
}

TEST_F(Names, ALongNameIsAnErrorOfTheFile) {
  const auto scan = made("a.xyz", "1 2 3\n4 5 6\n");
  for (const std::string& name : {std::string(300, 'a') + ".ply", std::string(5000, 'a') + "/b.ply"}) {
    const auto long_one = path(name);
    for (const std::string& problem :
         {problem_of_element(Element::file, [&] { open_points(long_one); }),
          problem_of_element(Element::file, [&] { create_points(long_one, {}); }),
          problem_of_element(Element::file, [&] { sample_file(scan, long_one, {.target = 1}); }),
          problem_of_element(Element::file, [&] { sample_file(long_one, path("b.ply"), {.target = 1}); }),
          problem_of_element(Element::file, [&] { read_cells(long_one); }),
          problem_of_element(Element::file, [&] { write_cells(long_one, {}); })})
      EXPECT_NE(problem.find("File name too long"), std::string::npos) << problem;
  }
}

// The temporary file beside the output has a longer name, which must not be too long.
TEST_F(Names, TheLongestNameIsPossible) {
  const std::string name = std::string(NAME_MAX - 4, 'a') + ".ply";
  const auto writer = create_points(path(name), {});
  writer->write({0, std::vector<double>{1, 2, 3}, {}, {}});
  writer->finish();
  EXPECT_EQ(open_points(path(name))->count(), 1U);
}

TEST_F(Names, AnEmptyNameIsABadOption) {
  const auto scan = made("a.xyz", "1 2 3\n4 5 6\n");
  for (const std::string& problem : {problem_of_element(Element::option, [&] { open_points(""); }),
                                     problem_of_element(Element::option, [&] { create_points("", {}); }),
                                     problem_of_element(Element::option, [&] { sample_file(scan, "", {.target = 1}); }),
                                     problem_of_element(Element::option, [&] { transfer(scan, scan, scan, ""); }),
                                     problem_of_element(Element::option, [&] {
                                       refine({scan, scan, scan, scan, "", ""}, {});
                                     })})
    EXPECT_NE(problem.find("is empty; name a file"), std::string::npos) << problem;
}

}  // namespace
}  // namespace glark::stream
