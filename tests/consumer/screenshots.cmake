# Takes the package's seaglass_add_screenshot_test() into the project in screenshots/: it fails without references,
# passes with them, and fails when a picture is another.
set(project ${work}/screenshots)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/screenshots/CMakeLists.txt DESTINATION ${project})
set(seaglass ${prefix}/bin/seaglass)
set(scenes ${prefix}/share/doc/seaglass/demos/scenes)

file(WRITE ${project}/warns "#!/bin/sh
if [ $1 = render ]; then echo 'warning: frame 0 holds 3 pixels of NaN or infinity' >&2; fi
exec ${seaglass} \"$@\"
")
file(CHMOD ${project}/warns PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

# tested(NAME CODE WORDS): runs one of its tests, which ends with CODE and says WORDS.
function(tested name code words)
  execute_process(COMMAND ctest --test-dir ${project}/build -R "^${name}$" --output-on-failure --no-tests=error
    RESULT_VARIABLE ended OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT ended EQUAL code OR NOT said MATCHES "${words}")
    message(FATAL_ERROR "${name} ended with ${ended}, expected ${code} and '${words}':\n${said}")
  endif()
endfunction()
# drawn(SIZE): the renderer's picture from now on.
function(drawn size)
  run(${seaglass} render ${scenes}/floor.toml --size ${size} -o ${project}/build/drawn.png)
endfunction()

run(${CMAKE_COMMAND} -G ${generator} -S ${project} -B ${project}/build -D SCENE=${scenes}/floor.toml
  -D SEA=${scenes}/ocean.toml
  -D CMAKE_PREFIX_PATH=${prefix})
tested(own 8 "what draws it ended with 1, expected 0")
tested(silent 8 "no PNG, EXR or HDR in")
drawn(48x27)
tested(own 8 "no reference .*own.png, expected one: seaglass bless")
tested("masked|scene|moving|broken|shell" 8 "5 tests failed out of 5")
run(${seaglass} bless ${project}/screenshots ${project}/build/screenshots/out --yes)
tested("own|masked|scene|moving|shell" 0 "100% tests passed")
# A PNG has no NaN, so that what draws it is heard.
tested(broken 8 "Regex=.pixels of NaN or infinity")
# A page of each test, and one of all.
file(READ ${project}/build/screenshots/report/index.html page)
foreach(words "own/deep/own.png</h2>" "</span>silent</h2>" "scene/depth.exr</h2>" "src=\"own/pictures/0/test.png\"")
  string(FIND "${page}" "${words}" place)
  if(place EQUAL -1 OR NOT EXISTS ${project}/build/screenshots/report/own/index.html)
    message(FATAL_ERROR "own leaves no report, or that of all lacks '${words}'")
  endif()
endforeach()
drawn(40x27)
tested(own 8 "own.png is 48x27 and .*own.png is 40x27, expected one size")

# What is left out may be anything; of intermediates the first that differs is named; a frozen sequence is one.
run(${seaglass} render ${scenes}/floor.toml --size 48x27 --set floor.roughness=0.5 -o ${project}/build/drawn.png)
tested(own 8 "lie together|mean FLIP")
tested(masked 0 "100% tests passed")
file(COPY_FILE ${project}/screenshots/moving/color_0000.png ${project}/screenshots/moving/color_0002.png)
file(COPY_FILE ${project}/screenshots/moving/color_0000.png ${project}/screenshots/moving/color_0001.png)
tested(moving 8 "color_\\*.png: the change to color_0001.png: ")
run(${seaglass} render ${scenes}/floor.toml --size 48x27 --aov reflection --set floor.roughness=0.5
  -o ${project}/screenshots/scene/reflection.exr)
tested(scene 8 "reflection.exr: .*the first stage that differs is reflection")
