# SPDX-License-Identifier: Apache-2.0
# From the list in krait/robots/all.hpp: krait_models, and of each krait_class_MODEL and krait_trailers_MODEL, true or
# false.
set(list ${PROJECT_SOURCE_DIR}/include/krait/robots/all.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
file(READ ${list} text)
string(REGEX MATCHALL "MODEL\\([a-z_0-9]+, [A-Za-z0-9]+, [a-z_0-9]+, [-0-9]+\\)" rows "${text}")
set(krait_models "")
foreach(row ${rows})
  string(REGEX MATCHALL "[-A-Za-z_0-9]+" row ${row})
  list(GET row 1 model)
  list(APPEND krait_models ${model})
  list(GET row 2 krait_class_${model})
  set(krait_trailers_${model} true)
  if(row MATCHES "-$")
    set(krait_trailers_${model} false)
  endif()
endforeach()
