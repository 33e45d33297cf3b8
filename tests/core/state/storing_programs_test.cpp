// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which programs may write buffers or images. What is kept of the draws of other programs is looked at again only when
// something else may have written.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "glark/core/state/programs/program.h"

namespace glark::core::test {
namespace {

bool stores(const std::string& fragment) {
  return may_store({{GL_VERTEX_SHADER, std::make_shared<const std::string>("void main() { gl_Position = vec4(0); }")},
                    {GL_FRAGMENT_SHADER, std::make_shared<const std::string>(fragment)}});
}

TEST(StoringPrograms, BlocksCountersAndImages) {
  EXPECT_TRUE(stores("#version 430\nlayout(std430) buffer Block { float value; };"));
  EXPECT_TRUE(stores("#version 430\nlayout(binding = 0) uniform atomic_uint counter;"));
  EXPECT_TRUE(stores("void main() { imageStore(picture, ivec2(0), vec4(1)); }"));
  EXPECT_TRUE(stores("void main() { imageAtomicAdd(picture, ivec2(0), 1u); }"));
  EXPECT_TRUE(stores("#extension GL_NV_shader_buffer_store : enable\nuniform vec4* place;"));
  EXPECT_TRUE(stores("/* a comment */buffer Block { float value; };"));
  EXPECT_TRUE(stores("// a comment\rbuffer Block { float value; };"));
}

TEST(StoringPrograms, NamesAndCommentsAreNoStores) {
  EXPECT_FALSE(stores("uniform sampler2D image; uniform samplerBuffer texels; in vec4 stored_colour, buffer0;"));
  EXPECT_FALSE(
      stores("uniform image2D picture; void main() { colour = imageLoad(picture, ivec2(imageSize(picture))); }"));
  EXPECT_FALSE(stores("// imageStore would write a buffer\nvoid main() {}"));
  EXPECT_FALSE(stores("/* a buffer,\n an imageStore */ void main() {} // buffer"));
  EXPECT_FALSE(stores("void main() {} /* buffer"));
}

TEST(StoringPrograms, WordsMadeOfParts) {
  EXPECT_TRUE(stores("#define JOIN(a, b) a##b\nJOIN(buf, fer) Block { float value; };"));
  EXPECT_TRUE(stores("buf\\\nfer Block { float value; };"));
  EXPECT_TRUE(stores("// a comment \\\r\nbuffer Block { float value; };"));
  EXPECT_FALSE(stores("#define TWICE(a) \\\n  (a + a)\nvoid main() {}"));
}

}  // namespace
}  // namespace glark::core::test
