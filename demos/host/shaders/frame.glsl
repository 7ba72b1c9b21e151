// What every pass of the host knows about the frame. Positions are in metres from the eye.
#ifndef FRAME_GLSL
#define FRAME_GLSL

layout(set = 0, binding = 0, std140) uniform Frame {
    mat4 clipFromEye;       // eye-relative position to clip
    mat4 shadowFromEye[4];  // eye-relative position to each shadow cascade's clip space
    vec4 skyRight;          // half the picture's width at distance 1
    vec4 skyUp;
    vec4 skyForward;        // w: how ragged clouds are between texels, 0 to 1
    vec4 toSun;             // w: 1 where the disc is drawn
    vec4 sunIrradiance;     // on a plane facing the sun
    vec4 sunRadiance;       // of the disc; w: half the width of its soft edge [rad]
    vec4 irradianceSh[9];   // of the sky, a polynomial of the normal
    vec4 sky;               // rotation [turns], intensity, last mip of the cube, face size
    vec4 shadowTexelM;      // of each cascade, 0 where it is not drawn
    vec4 shadow;            // texel of a cascade [uv]
    vec4 waterPlane;        // whose calm surface bends the sun: height over it; 0: none
    vec4 waterAcross;       // along the surface: -1 to 1 where there is water
    vec4 waterAlong;        // across that
    vec4 sunShear;          // on each metre of depth; how deep troughs are [m]
    vec4 sunStrays[2];      // along the surface, a deviation of where waves send rays on each metre of depth; w: their length
    vec4 sight;             // where lines of sight are parallel their direction, and 0; else 0, and 1
    vec4 fogColor;          // SeaglassFog; its shape 0: none
    vec4 fogForm;
    vec4 fogReach;
    vec4 fogEye;            // whose lines of sight it lies on; w: their near plane's distance
    vec4 fogSight;          // likewise, as `sight`
    vec4 fogWater;          // height over the calm water, of positions relative to that eye; under it there is no fog
    vec4 shorePlace;        // SeaglassShore
    vec4 shoreRows;
    vec4 shoreForm;
    vec4 shoreU;            // of positions relative to the eye: along u, up from the calm water, along v
    vec4 shoreUp;
    vec4 shoreV;
} frame;

// Irradiance from the sky on a plane with unit normal n (Ramamoorthi and Hanrahan 2001).
vec3 skyIrradiance(vec3 n) {
    vec3 e = frame.irradianceSh[0].rgb
        + frame.irradianceSh[1].rgb * n.y
        + frame.irradianceSh[2].rgb * n.z
        + frame.irradianceSh[3].rgb * n.x
        + frame.irradianceSh[4].rgb * (n.x * n.y)
        + frame.irradianceSh[5].rgb * (n.y * n.z)
        + frame.irradianceSh[6].rgb * (3.0 * n.z * n.z - 1.0)
        + frame.irradianceSh[7].rgb * (n.x * n.z)
        + frame.irradianceSh[8].rgb * (n.x * n.x - n.y * n.y);
    return max(e, vec3(0.0));
}

#endif
