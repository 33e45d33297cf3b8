/* SPDX-FileCopyrightText: 2026 The glark authors */
/* SPDX-License-Identifier: MIT */
/*
 * Uses every kind of declaration of glark.h, twice included, after GLARK_HEADER_BEFORE if that is given. C and C++.
 */
#ifdef GLARK_HEADER_BEFORE
#include GLARK_HEADER_BEFORE
#endif
#include <GL/glark.h>

#if !GL_ARK_adaptive_refinement
#error "glark.h does not announce the extension"
#endif

struct functions {
  PFNGLARKINITPROC ark_init;
  PFNGLARKPARAMETERIARKPROC ark_parameter;
  PFNGLARKPARAMETERFARKPROC ark_number;
  PFNGLDEPTHTAG1IPROC depth_tag;
  PFNGLDEPTHTAGPOINTERARKPROC depth_tag_pointer;
  PFNGLDRAWARPPROC draw_arp;
  PFNGLDRAWARPELEMENTSARKPROC draw_arp_elements;
  PFNGLREFINEMENTSHADERSOURCEARKPROC refinement_shader_source;
  PFNGLGETREFINEMENTIVARKPROC get_refinement;
  PFNGLGETREFINEMENTINFOLOGARKPROC get_refinement_info_log;
};

#ifdef GLARK_NO_PROTOTYPES
/* Must not collide with a declaration of the header. */
static int glARKinit(void) { return 0; }
int use(void);
int use(void) { return glARKinit(); }
#else
/* Initialisation fails to compile where a function and its type differ. */
extern const struct functions linked;
const struct functions linked = {
    glARKinit, glARKParameteriARK,   glARKParameterfARK,          glDepthTag1i,         glDepthTagPointerARK,
    glDrawARP, glDrawARPElementsARK, glRefinementShaderSourceARK, glGetRefinementivARK, glGetRefinementInfoLogARK,
};

void use(const GLchar* source);
void use(const GLchar* source) {
  GLint status;
  glARKinit(4);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glRefinementShaderSourceARK(1, 1, &source, 0);
  glGetRefinementivARK(1, GL_REFINEMENT_STATUS_ARK, &status);
}
#endif
