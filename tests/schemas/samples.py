"""Good files, of which mutants are made."""

AXIS = '"vector":[0,1,0]'
SCENE = f"""{{"format":"durero-scene","version":1,
"camera":{{"eye":[0,1,-8],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45,"aperture":0.5,"focus":7,"shutter":2,"motion":[0,3,0],"mirrored":true}},
"resolution":[8,6],"background":[0,0.5,2],"lights":[{{"position":[5,5,-5],"color":[1,1,1]}},{{"position":[6,5,-5],"color":[1,1,1],"disc":{{"radius":0.75,"normal":[0,-1,0.5]}}}},
{{"position":[7,5,-5],"color":[1,1,1],"rectangle":{{"edges":[[1,0,0],[0,0,9]]}},"spot":{{"towards":[0,0,7],"inner":15,"outer":25,"tightness":2.5}}}}],
"directional_lights":[{{"direction":[0,-1,0],"color":[0.5,0.5,1]}}],"materials":{{"red":{{"color":[1,0,0]}},"azul ñ":{{"color":[0,0,1],"k_a":0.1,"k_d":0.7,"k_s":0.2,"e":50,"k_ps":0.3,"gloss":12,"M_PS":[1,0.9,0.8],
"k_t":0.6,"M_T":[0.9,1,1],"index":1.5,"emission":[0,2,0],"ambient":[0.1,0.2,0.3],"textures":{{"color":"pic","k_s":"p"}},
"bump":{{"texture":"w","height":-0.5,"delta":0.25}}}}}},"max_depth":9,
"textures":{{"pic":{{"image":"a.png","repeat":[2,3],"filter":"mipmap","near":4,"edges":"clamp","curve":"linear"}},"p":{{"p6m":[[0,0,1],[1,1,0]]}},
"w":{{"waves":[[0,0,0],[1,1,1]]}}}},"environment":{{"gradient":[[0,0,0.25],[3,0,0]]}},
"groups":{{"all":{{"elementos":["s1"],"groups":["pair"]}},"pair":{{"elementos":["c1","k1"]}},"none":{{}}}},"elementos":[
{{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red","motion":[0,0,7]}},
{{"id":"c1","tipo":"cilindro","centro":[3,0,0],"radio":1,{AXIS},"altura":2}},
{{"id":"k1","tipo":"cono","centro":[-3,0,0],"proporcion":0.5,{AXIS},"altura":2,"material":"azul ñ"}},
{{"id":"t1","tipo":"tronco","centro":[6,0,0],"radio":1,"proporcion":0.5,"vector":[0.6,0.8,0],"altura":2}},
{{"id":"p1","tipo":"plano","centro":[0,-5,0],{AXIS}}},
{{"id":"d1","tipo":"disco","centro":[0,3,0],"radio":2,{AXIS}}},
{{"id":"v1","tipo":"triangulo","vertices":[[0,0,9],[1,0,9],[0,1,9]]}}]}}"""
OPERATIONS = ['{"op":"Agregar_Esfera","e":"n","centro":[0,0,5],"radio":1,"material":"red"}',
              '{"op":"Agregar_Cono","e?":"n","centro?":[0,0,5],"proporcion?":1,"vector?":[0,1,0],"altura?":1}',
              '{"op":"Agregar_Triangulo","e":"n","vertices":[[0,0,0],[1,0,0],[0,1,0]]}',
              '{"op":"Agregar_Elemento","e":"n","t":"soy_disco","centro":[0,0,0],"radio":1,"vector":[1,0,0],'
              '"altura":3}',
              '{"op":"group","g":"new","elementos":["t1","p1"],"groups?":["all"]}', '{"op":"ungroup","g?":"pair"}',
              '{"op":"Eliminar_Esfera","e":"s1"}', '{"op":"Eliminar_Elemento","e?":"c1"}']
RAYS = "0 0 -9 0 0 1\n0 9 0 0 1 0\n3 -1 0 0 1 0\n"
HITS = ['{"ray":0,"outcome":"hit","elementos":["s1"],"t":8,"point":[0,0,-1]}',
        '{"ray":1,"outcome":"miss","elementos":[]}',
        '{"ray":2,"outcome":"no_minimum","elementos":["c1","s1"]}',
        '{"ray":0,"outcome":"hit","elementos":["s1","v1"],"t":"inf","point":["inf",0,"-inf"]}']
CLAIMS = ['{"case":"generic/0000","ray":0,"outcome":"hit","element":"e0","t":4,"point":[0,0,4]}',
          '{"case":"generic/0000","ray":1,"outcome":"miss"}',
          '{"case":"generic/0000","ray":0,"outcome":"crashed","why":"x"}',
          '{"case":"generic/0000","ray":1,"outcome":"hit","t":"nan","point":["inf",0,"-inf"]}']
PROFILE = """"profile":{"format":"binary32","tipos":["esfera","cono"],"caps":"solid","measure":"length",
"directions":"unit","inside":"nothing","names_elements":true,"thickness":0,
"least_t":0.001,"greatest_t":1e10,"watertight":false},
"sources":[{"claim":"measure","sentence":"It is t.","place":"manual"}]"""
PROFILES = ['{"format":"durero-profile","version":1,"system":"mine",' + PROFILE + "}"]
SYSTEMS = ["""{"format":"durero-system","version":1,"system":"mutant","title":"Mine","ask":["{out}","open"],
"build":["c++"],
"install":{"debian":["g++"],"pypi":["a==1"]},
"reproduce":{"program":"r.py","words":{"a":"b"},"run":[["{python}","{program}"]]},
"known":[{"verdicts":["off"],"types":["cono"],"cause":"So it is."}],""" + PROFILE + "}"]
CAMPAIGNS = ['{"format":"durero-campaign","version":1,"system":"durero","seed":1,"rays_of_a_shard":2048,"shards":4,'
             '"families":["generic","rim"],"types":["esfera","cono"],"solids":true,"numbers":"binary64","time":2.5}',
             '{"format":"durero-campaign","version":1,"system":"command:true","profile":"durero","seed":0,'
             '"rays_of_a_shard":4294967296,"shards":2097152}']

# What is changed in the first sample of each, one thing at a time: what stands, then what stands there instead. The
# first rows give one mutant of each class of differences; each of the others gives both sides of a border.
LONGEST, TOO_LONG = (f'"{"x" * length}"' for length in (128, 129))
NO_UNICODE = r'"\ud800"'
CHANGES = {
    "scene": rf"""
"id":"c1" | "id":"s1"
[0.6,0.8,0] | [0.6,0.9,0]
[0,1,9] | [2,0,9]
"look_at":[0,0,0] | "look_at":[0,1,-8]
"towards":[0,0,7] | "towards":[7,5,-5]
"outer":25 | "outer":14
"material":"red" | "material":"rojo"
"azul ñ" | {NO_UNICODE}
"s1" | {LONGEST} | {TOO_LONG}
"c1" | "9._:-Zz" | "9/"
"radio":1 | "radio":5e-324 | "radio":0
"altura":2 | "altura":1.7976931348623157e308 | "altura":1.8e308
"proporcion":0.5 | "proporcion":5e-324 | "proporcion":0
"fov_y":45 | "fov_y":179.9 | "fov_y":180
"fov_y":45 | "fov_y":1e-9 | "fov_y":0
"aperture":0.5 | "aperture":0 | "aperture":-5e-324
"focus":7 | "focus":5e-324 | "focus":0
"shutter":2 | "shutter":0 | "shutter":"2"
"motion":[0,3,0] | "motion":[0,0,0] | "motion":[0,0]
"mirrored":true | "mirrored":false | "mirrored":1
"motion":[0,0,7] | "motion":[0,0,0] | "motion":7
"gloss":12 | "gloss":0 | "gloss":-1
"radius":0.75 | "radius":5e-324 | "radius":0
"normal":[0,-1,0.5] | "normal":[0,0,5e-324] | "normal":[0,0,0]
{{"edges":[[1,0,0],[0,0,9]]}} | {{"edges":[[1,0,0],[0,1,9]]}} | {{"edges":[[1,0,0]]}}
"rectangle":{{ | "triangle":{{ | "square":{{
"inner":15 | "inner":0 | "inner":-1
"outer":25 | "outer":90 | "outer":90.5
"tightness":2.5 | "tightness":0 | "tightness":-1
"disc":{{"radius":0.75, | "disc":{{"radius":0.75, | "sphere":{{"radius":0.75,
[8,6] | [1,65535] | [1,65536]
[8,6] | [1,1] | [0,1]
[8,6] | [8.0,6] | [8.5,6]
[1,0,0] | [1,0,1] | [1,0,1.0000000000000002]
"k_ps":0.3 | "k_ps":1 | "k_ps":1.0000000000000002
"k_t":0.6 | "k_t":0 | "k_t":-5e-324
"e":50 | "e":0 | "e":-5e-324
"index":1.5 | "index":5e-324 | "index":0
"M_T":[0.9,1,1] | "M_T":[0,0,1] | "M_T":[0,0,1.0000000000000002]
"emission":[0,2,0] | "emission":[0,0,0] | "emission":[0,-5e-324,0]
"max_depth":9 | "max_depth":1000 | "max_depth":1001
"max_depth":9 | "max_depth":1.0 | "max_depth":0
"k_s":"p" | "k_s":"w" | "k_s":"q"
"texture":"w" | "texture":"pic" | "texture":"q"
"delta":0.25 | "delta":5e-324 | "delta":0
"height":-0.5 | "height":0 | "height":"0"
[2,3] | [5e-324,3] | [0,3]
"near":4 | "near":5e-324 | "near":0
"filter":"mipmap","near":4 | "filter":"linear" | "filter":"linear","near":4
"filter":"mipmap","near":4 | "filter":"nearest" | "filter":"mipmap"
"edges":"clamp" | "edges":"repeat" | "edges":"Clamp"
"image":"a.png" | "image":"b/c.jpg" | "image":""
{{"p6m":[[0,0,1],[1,1,0]]}} | {{"stripes":[[0,0,1],[1,1,0]]}} | {{"stripes":[[0,0,1],[1,1,0]],"edges":"clamp"}}
{{"p6m":[[0,0,1],[1,1,0]]}} | {{"checker":[[0,0,1],[1,1,1]]}} | {{}}
[[0,0,1],[1,1,0]] | [[0,0,0],[1,1,1]] | [[0,0,0],[1,1,1.0000000000000002]]
[[0,0,0.25],[3,0,0]] | [[0,0,0],[0,0,1e300]] | [[0,0,-5e-324],[0,0,0]]
{{"gradient":[[0,0,0.25],[3,0,0]]}} | {{"box":["a","b","c","d","e","f"]}} | {{"box":["a","b","c","d","e"]}}
{{"gradient":[[0,0,0.25],[3,0,0]]}} | {{"spherical":"a"}} | {{"spherical":"a","equirectangular":"b"}}
"pic":{{ | "pic":{{ | "":{{
[0,0.5,2] | [0,0,0] | [0,0,-5e-324]
"up":[0,1,0] | "up":[0,5e-324,0] | "up":[0,-0.0,0]
"red": | "\u0000": | "":
"direction":[0,-1,0] | "direction":[0,5e-324,0] | "direction":[0,-0.0,0]
"direction":[0,-1,0] | "direction":[0,1,0] | "direction":[0,1]
"version":1 | "version":1.0 | "version":true
"groups":["pair"] | "groups":["all"] | "groups":["pair","pair"] | "groups":["nobody"] | "groups":["a b"]
["c1","k1"] | ["c1","c1"] | ["c1","s1"] | ["c1","x1"] | [] | "c1"
"pair":{{ | "{LONGEST[1:-1]}":{{ | "":{{
"version":1 | "version":1 | "version":2""",
    "operation": rf"""
"red" | "rojo"
"red" | {NO_UNICODE}
"e":"n" | "e":{LONGEST} | "e":{TOO_LONG}
"radio":1 | "radio":-1 | "radio":"1"
"radio": | "radio?": | "radio??":""",
    "hit": """
"s1" | "s2"
"ray":0 | "ray":3
"t":8 | "t":"-inf" | "t":"nan"
["s1"] | ["s1","c1"] | ["s1","s1"]
"ray":0 | "ray":0.0 | "ray":-1
"ray":0 | "ray":2 | "ray":0.5
"hit" | "hit" | "no_minimum"
""",
    "claim": rf"""
generic/0000 | generic/0001
"ray":0 | "ray":2
"e0" | "e99"
"e0" | {NO_UNICODE}
"t":4 | "t":"nan" | "t":"NaN"
"hit" | "hit" | "crashed"
""",
    "profile": rf"""
"manual" | {NO_UNICODE}
"thickness":0 | "thickness":-0 | "thickness":-5e-324
"manual" | "\u0000" | ""
["esfera","cono"] | ["cono","cono"] | []
"measure","s | "watertight","s | "tight","s""",
    "system": rf"""
"system":"mutant" | "system":"other"
"So it is." | {NO_UNICODE}
["c++"] | [""] | []
"So it is." | "" | []
{{"a":"b"}} | {{}} | {{"a":1}}""",
    "campaign": rf"""
"rim" | "rhyme"
"shards":4 | "shards":9007199254740992
"system":"durero" | "system":{NO_UNICODE}
"time":2.5 | "time":0.001 | "time":0.0009
"time":2.5 | "time":86400 | "time":86400.1
"shards":4 | "shards":1 | "shards":0
"seed":1 | "seed":9007199254740992 | "seed":9007199254740994
"seed":1 | "seed":0 | "seed":-1
"rim" | "inside" | "generic"
"system":"durero" | "system":"command" | "system":"command:"
"""}
