import numpy as np, acoustic_fem, geometry, localize, warnings, subprocess, sys, time
warnings.simplefilter("ignore")
from localize.embedded.tables import embedded_tables
from localize.embedded.source import source_files
from localize.signals.array_response import response_of
import pathlib
from localize.signals.finger_stimuli import STIMULI
name=sys.argv[1]; prec=sys.argv[2]
lib=acoustic_fem.solve(geometry.prototype(name),np.arange(1.,501.),"lumped")
t0=time.time(); t=embedded_tables(lib,prec); print('tables',time.time()-t0, t.rank, t.size)
out=pathlib.Path(f'/tmp/ece/{name}-{prec}'); out.mkdir(exist_ok=True)
for n,s in source_files(t).items(): (out/n).write_text(s)
r=subprocess.run(f"cd {out} && gcc -std=c99 -O2 -Wall -Wextra -Wconversion -Werror -pedantic touch_bench.c touch_decoder.c touch_tables.c -lm -o bench"+" 2>&1 | head -5",shell=True); print(r.returncode)
# stream
dec=localize.BayesDecoder(lib,"design")
from localize.decoders.sound_test import SoundTest
from localize.live.front_end import Listening
g=localize.TouchGenerator(response_of(lib),3,"evaluation","design",stimuli=STIMULI["taps"]).samples(0,30).signals.double().numpy()
m=localize.TouchGenerator(response_of(lib),3,"evaluation","design").samples(0,30).signals.double().numpy()
nan=np.full((g.shape[1],1),np.nan); sig=np.concatenate([x for p in zip(g,m) for x in (p[0],nan,p[1],nan)],axis=1)
noise=localize.TouchGenerator(response_of(lib),4,"evaluation","design").samples(0,1)
sig=sig.astype(np.float32)
st=localize.TouchStream(dec,listening=Listening(3.0,False,True),sound_test=SoundTest(lib,"design"))
t0=time.time(); ev=st.push(sig.astype(np.float64)); print('py',time.time()-t0,len(ev))
raw=subprocess.run([str(out/'bench'),"37"],input=np.ascontiguousarray(sig.T).tobytes(),capture_output=True).stdout.decode().splitlines()
print(len(raw))
names={0:"no touch",1:"fading",2:"sound",3:"touch",4:"unreadable"}
al=[]; bad=0; worst=0; touches=0; samep=0; from collections import Counter
cnt=Counter()
ev=[e for e in ev if hasattr(e,"state")]
print(len(ev))
for e,l in zip(ev,raw):
    f=l.split(); s=names[int(f[1])]
    if s!=e.state: bad+=1; print(l[:60],e) if bad<5 else 0
    cnt[s]+=1
    if s=="touch" and e.state=="touch":
        p=np.array(f[4:],float); touches+=1; al.append((np.abs(p-e.distribution).max(), e.time%2.002>1, e.level)); worst=max(worst,np.abs(p-e.distribution).max()); samep+=int(f[3])==e.point
print('states differ',bad,cnt,'posterior',worst,'same point',samep,touches)

al=np.array(al); 
for k in (0,1): q=al[al[:,1]==k]; i=np.argsort(-q[:,0])[:3]; print(["taps","sines"][k],q[i][:, [0,2]].round(6).tolist(),len(q))
