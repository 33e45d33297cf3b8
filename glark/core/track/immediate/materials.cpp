// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glMaterial. Between glBegin and glEnd, each fixed-function vertex has its own material. A vertex program
// sees the material from before glBegin.
#include <algorithm>
#include <cstring>
#include <vector>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// The number of values of a material parameter; 1 for names that GL refuses.
std::size_t values_of(GLenum name) {
  switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE: return 4;
    case GL_COLOR_INDEXES: return 3;
    default: return 1;
  }
}

GLfloat component_of(GLenum, GLfloat value) { return value; }
// OpenGL 4.6 compatibility, 2.3.5: integers of colours are signed normalised numbers.
GLfloat component_of(GLenum name, GLint value) {
  return name == GL_SHININESS ? static_cast<GLfloat>(value)
                              : static_cast<GLfloat>(std::max(value / 2147483647.0, -1.0));
}

// CurrentValue::Again of an attribute that glark has read.
void set_attribute(const gl::Dispatch& gl, GLuint attribute, const void* components) {
  gl.VertexAttrib4fv(attribute, static_cast<const GLfloat*>(components));
}

CurrentValue read_attribute(const Context& c, GLuint attribute) {
  CurrentValue value{.again = set_attribute, .index = attribute, .bytes = 4 * sizeof(GLfloat)};
  std::array<GLfloat, 4> components{};
  c.gl().GetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, components.data());
  std::memcpy(value.components.data(), components.data(), value.bytes);
  return value;
}

CurrentValue value_of_attribute(Context& c, GLuint attribute) {
  const CurrentValue* known = c.state().arrays().current_values().find(generic_slot(attribute));
  return known != nullptr ? *known : read_attribute(c, attribute);
}

// Calls `visit` with each parameter and its attribute.
template <typename Visit>
void for_each_attribute(const Context& c, MaterialSet parameters, Visit&& visit) {
  const MaterialAttributes attributes = material_attributes(parameters, c.ark());
  for_each_parameter(parameters, [&](int parameter) {
    visit(parameter, static_cast<GLuint>(attributes[static_cast<std::size_t>(parameter)]));
  });
}

template <typename Value>
MaterialChange change_of(GLenum face, GLenum name, const Value* values, std::size_t count,
                         void (*call)(const gl::Dispatch&, const MaterialChange&)) {
  MaterialChange change{.call = call, .face = face, .name = name};
  std::memcpy(change.words.data(), values, count * sizeof(Value));
  std::transform(values, values + count, change.components.begin(),
                 [name](Value value) { return component_of(name, value); });
  return change;
}

template <typename Value>
std::array<Value, 4> values_in(const MaterialChange& change) {
  std::array<Value, 4> values{};
  std::memcpy(values.data(), change.words.data(), sizeof(values));
  return values;
}

}  // namespace

namespace track {

void begin_materials(Context& c, MaterialSet parameters) {
  VertexMaterials& materials = c.state().immediate().materials();
  CurrentValues& values = c.state().arrays().current_values();
  materials.carry(parameters);
  for_each_attribute(c, parameters, [&](int parameter, GLuint attribute) {
    materials.displaced(parameter) = value_of_attribute(c, attribute);
    values.set(generic_slot(attribute), materials.displaced(parameter));
    std::array<GLfloat, 4> components{0, 0, 0, 1};
    c.gl().GetMaterialfv(face_of(parameter), name_of(parameter), components.data());
    c.gl().VertexAttrib4fv(attribute, components.data());
  });
}

void end_materials(Context& c) {
  VertexMaterials& materials = c.state().immediate().materials();
  for_each_attribute(c, materials.carried(), [&](int parameter, GLuint attribute) {
    const CurrentValue* known = c.state().arrays().current_values().find(generic_slot(attribute));
    const CurrentValue& value = known != nullptr ? *known : materials.displaced(parameter);
    value.again(c.gl(), value.index, value.components.data());
  });
  materials.carry(0);
}

void carry_change(Context& c, const MaterialChange& change, MaterialSet parameters) {
  for_each_attribute(c, parameters, [&](int parameter, GLuint attribute) {
    const bool refused = name_of(parameter) == GL_SHININESS && (change.components[0] < 0 || change.components[0] > 128);
    if (!refused) {
      c.gl().VertexAttrib4fv(attribute, change.components.data());
    }
  });
}

void record_material(Context& c, const MaterialChange& change) {
  ListCompilation& lists = c.state().lists();
  const bool before_vertices = c.state().immediate().before_vertices();
  c.changes().forget_in_list();
  lists.note_material(change, before_vertices);
  change.call(c.gl(), change);
  if (!lists.primitive().open() || !is_triangle_mode(lists.primitive().mode())) {
    return;
  }
  if (before_vertices && replaces_fixed_function(c)) {
    SegmentMaterials& materials = lists.effects().materials;
    materials.carried |= change.parameters();
    materials.attributes = material_attributes(materials.carried, c.ark());
  }
  carry_change(c, change, change.parameters() & lists.effects().materials.carried);
}

// Without refinement, the list gives the attributes the values that they have now, or that it sets itself. A refined draw
// gives them back as it found them.
void record_materials_end(Context& c) {
  const SegmentEffects& effects = c.state().lists().effects();
  for_each_attribute(c, effects.materials.carried, [&](int, GLuint attribute) {
    const CurrentValue* own = effects.find(generic_slot(attribute));
    const CurrentValue value = own != nullptr ? *own : read_attribute(c, attribute);
    value.again(c.gl(), attribute, value.components.data());
  });
}

std::vector<CurrentValue> values_under_materials(Context& c, const SegmentEffects& effects) {
  std::vector<CurrentValue> values;
  for_each_attribute(c, effects.materials.carried, [&](int, GLuint attribute) {
    if (effects.find(generic_slot(attribute)) == nullptr) {
      values.push_back(value_of_attribute(c, attribute));
    }
  });
  return values;
}

}  // namespace track

namespace hook {

void Materialf(Context& c, GLenum face, GLenum name, GLfloat value) {
  track::change_material(c, change_of(face, name, &value, 1, [](const gl::Dispatch& gl, const MaterialChange& change) {
                           gl.Materialf(change.face, change.name, values_in<GLfloat>(change)[0]);
                         }));
}

void Materiali(Context& c, GLenum face, GLenum name, GLint value) {
  track::change_material(c, change_of(face, name, &value, 1, [](const gl::Dispatch& gl, const MaterialChange& change) {
                           gl.Materiali(change.face, change.name, values_in<GLint>(change)[0]);
                         }));
}

void Materialfv(Context& c, GLenum face, GLenum name, const GLfloat* values) {
  track::change_material(
      c, change_of(face, name, values, values_of(name), [](const gl::Dispatch& gl, const MaterialChange& change) {
        gl.Materialfv(change.face, change.name, values_in<GLfloat>(change).data());
      }));
}

void Materialiv(Context& c, GLenum face, GLenum name, const GLint* values) {
  track::change_material(
      c, change_of(face, name, values, values_of(name), [](const gl::Dispatch& gl, const MaterialChange& change) {
        gl.Materialiv(change.face, change.name, values_in<GLint>(change).data());
      }));
}

}  // namespace hook
}  // namespace glark::core
