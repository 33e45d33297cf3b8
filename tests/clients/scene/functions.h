// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The functions that the scenes and the GLX clients call. Some clients find each of these functions by its name.
#pragma once

// Each run of clang-format 14 breaks these lists differently.
// clang-format off
#define SCENE_FIXED_FUNCTIONS(X)                                                                                    \
  X(Begin)                                                                                                          \
  X(Clear)                                                                                                          \
  X(ClearColor)                                                                                                     \
  X(Color3f)                                                                                                        \
  X(ColorMaterial)                                                                                                  \
  X(DisableClientState)                                                                                             \
  X(DrawArrays)                                                                                                     \
  X(DrawElements)                                                                                                   \
  X(Enable)                                                                                                         \
  X(EnableClientState)                                                                                              \
  X(End) X(Finish) X(Frustum) X(GetError) X(Lightfv) X(LoadIdentity) X(MatrixMode) X(Normal3f) X(NormalPointer)     \
      X(PixelStorei) X(PopMatrix) X(PushMatrix) X(ReadPixels) X(Rotatef) X(Translatef) X(Vertex3f) X(VertexPointer) \
          X(Viewport)

#define SCENE_SHADER_FUNCTIONS(X)                                                                                  \
  X(AttachShader)                                                                                                  \
  X(BindAttribLocation)                                                                                            \
  X(BindBuffer)                                                                                                    \
  X(BufferData)                                                                                                    \
  X(Clear)                                                                                                         \
  X(ClearColor)                                                                                                    \
  X(CompileShader)                                                                                                 \
  X(CreateProgram)                                                                                                 \
  X(CreateShader)                                                                                                  \
  X(DrawArrays)                                                                                                    \
  X(DrawElements) X(Enable) X(EnableVertexAttribArray) X(Finish) X(GenBuffers) X(GetError) X(GetProgramiv)         \
      X(GetUniformLocation) X(LinkProgram) X(PixelStorei) X(ReadPixels) X(ShaderSource) X(Uniform3f) X(UseProgram) \
          X(VertexAttribPointer) X(Viewport)

#define GLX_CLIENT_FUNCTIONS(X) X(ChooseVisual) X(CreateContext) X(DestroyContext) X(MakeCurrent) X(SwapBuffers)

// Declares members of a struct of function pointers. Their types are those of GL's own headers.
#define DECLARE_GL(name) __typeof__(&gl##name) gl##name;
#define DECLARE_GLX(name) __typeof__(&glX##name) glX##name;
// clang-format on
