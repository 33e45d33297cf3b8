// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The functions of libfmt that are not templates, compiled once. As headers only, they cost every file that formats a
// message two seconds; as Debian's shared library, they would be a new dependency of libGLARK.so.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail {

#if FMT_VERSION >= 100000
using FormatArguments = vformat_args<char>::type;
#else
using FormatArguments = basic_format_args<FMT_BUFFER_CONTEXT(char)>;
#endif

template FMT_API auto dragonbox::to_decimal(float x) noexcept -> dragonbox::decimal_fp<float>;
template FMT_API auto dragonbox::to_decimal(double x) noexcept -> dragonbox::decimal_fp<double>;
template FMT_API locale_ref::locale_ref(const std::locale& loc);
template FMT_API auto locale_ref::get<std::locale>() const -> std::locale;
template FMT_API auto thousands_sep_impl(locale_ref) -> thousands_sep_result<char>;
template FMT_API auto decimal_point_impl(locale_ref) -> char;
template FMT_API void buffer<char>::append(const char* begin, const char* end);
template FMT_API void vformat_to(buffer<char>& out, string_view text, FormatArguments arguments, locale_ref locale);

}  // namespace detail
FMT_END_NAMESPACE
