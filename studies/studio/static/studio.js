"use strict";(()=>{var Zm="acoustic-fem-studio-secret",ec="";function Jm(){let i=document.querySelector("meta[name=secret]");if(i){ec=i.content,i.remove();try{localStorage.setItem(Zm,ec)}catch{}}location.search&&history.replaceState(null,"",`/${location.hash}`)}function dd(){try{return localStorage.getItem(Zm)??ec}catch{return ec}}function tc(){return{"x-studio-secret":dd()}}var pr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},mr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Hg=0,jd=1,Vg=2;var pl=1,Gg=2,Yo=3,xs=0,si=1,Di=2,Vr=0,Ko=1,Zd=2,Jd=3,Qd=4,Wg=5;var Gr=100,Xg=101,qg=102,$g=103,Yg=104,Kg=200,jg=201,Zg=202,Jg=203,ef=204,tf=205,Qg=206,e0=207,t0=208,n0=209,i0=210,s0=211,r0=212,o0=213,a0=214,Cc=0,Pc=1,Ic=2,Co=3,Lc=4,Nc=5,Dc=6,Oc=7,nf=0,l0=1,c0=2,_s=0,sf=1,rf=2,of=3,af=4,lf=5,cf=6,hf=7,Fd="attached",h0="detached",uf=300,Wr=301,jo=302,Qc=303,eh=304,hr=1e3,Ii=1001,Po=1002,an=1003,th=1004;var Xr=1005;var bn=1006,Zo=1007;var Oi=1008;var ci=1009,df=1010,ff=1011,Jo=1012,nh=1013,ji=1014,yi=1015,Zi=1016,ih=1017,sh=1018,qr=1020,pf=35902,mf=35899,gf=1021,xf=1022,Ui=1023,Fs=1026,qs=1027,rh=1028,oh=1029,gr=1030,ah=1031;var lh=1033,ml=33776,gl=33777,xl=33778,_l=33779,ch=35840,hh=35841,uh=35842,dh=35843,fh=36196,ph=37492,mh=37496,gh=37488,xh=37489,vl=37490,_h=37491,vh=37808,yh=37809,bh=37810,Sh=37811,Mh=37812,wh=37813,Th=37814,Eh=37815,Ah=37816,Rh=37817,Ch=37818,Ph=37819,Ih=37820,Lh=37821,Nh=36492,Dh=36494,Oh=36495,Uh=36283,Fh=36284,yl=36285,kh=36286;var Dr=2300,Or=2301,Ac=2302,kd=2303,Bd=2400,zd=2401,Hd=2402,u0=2500;var _f=0,bl=1,Qo=2,d0=3200;var Bh=0,f0=1,$s="",vn="srgb",ti="srgb-linear",Ha="linear",Ct="srgb";var Rc=7680;var p0=519,m0=512,g0=513,x0=514,vf=515,_0=516,v0=517,yf=518,bf=519,Sf=35044;var Mf="300 es",Li=2e3,Io=2001;function ty(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ny(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Lo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function y0(){let i=Lo("canvas");return i.style.display="block",i}var Qm={},No=null;function Va(...i){let e="THREE."+i.shift();No?No("log",e,...i):console.log(e,...i)}function b0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){i=b0(i);let e="THREE."+i.shift();if(No)No("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=b0(i);let e="THREE."+i.shift();if(No)No("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Nr(...i){let e=i.join(" ");e in Qm||(Qm[e]=!0,qe(...i))}function S0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var M0={[Cc]:Cc,[Ic]:Dc,[Lc]:Lc,[Co]:Nc,[Pc]:Pc,[Dc]:Ic,[Oc]:Oc,[Nc]:Co},Ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],eg=1234567,Ba=Math.PI/180,Ur=180/Math.PI;function vs(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Wn[i&255]+Wn[i>>8&255]+Wn[i>>16&255]+Wn[i>>24&255]+"-"+Wn[e&255]+Wn[e>>8&255]+"-"+Wn[e>>16&15|64]+Wn[e>>24&255]+"-"+Wn[t&63|128]+Wn[t>>8&255]+"-"+Wn[t>>16&255]+Wn[t>>24&255]+Wn[n&255]+Wn[n>>8&255]+Wn[n>>16&255]+Wn[n>>24&255]).toLowerCase()}function gt(i,e,t){return Math.max(e,Math.min(t,i))}function wf(i,e){return(i%e+e)%e}function iy(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function sy(i,e,t){return i!==e?(t-i)/(e-i):0}function za(i,e,t){return(1-t)*i+t*e}function ry(i,e,t,n){return za(i,e,1-Math.exp(-t*n))}function oy(i,e=1){return e-Math.abs(wf(i,e*2)-e)}function ay(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function ly(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function cy(i,e){return i+Math.floor(Math.random()*(e-i+1))}function hy(i,e){return i+Math.random()*(e-i)}function uy(i){return i*(.5-Math.random())}function dy(i){i!==void 0&&(eg=i);let e=eg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function fy(i){return i*Ba}function py(i){return i*Ur}function my(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function gy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Tf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function xy(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),c=o(t/2),l=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,c*u,c*d,a*l);break;case"YZY":i.set(c*d,a*h,c*u,a*l);break;case"ZXZ":i.set(c*u,c*d,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function zh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ef(i,e){if(e.constructor===Float32Array)return i;let t=zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Af(i,e){if(e.constructor===Float32Array)return i;let t=zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ea={DEG2RAD:Ba,RAD2DEG:Ur,generateUUID:vs,clamp:gt,euclideanModulo:wf,mapLinear:iy,inverseLerp:sy,lerp:za,damp:ry,pingpong:oy,smoothstep:ay,smootherstep:ly,randInt:cy,randFloat:hy,randFloatSpread:uy,seededRandom:dy,degToRad:fy,radToDeg:py,isPowerOfTwo:my,ceilPowerOfTwo:gy,floorPowerOfTwo:Tf,setQuaternionFromProperEuler:xy,normalize:Af,denormalize:Ef},Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},On=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(u!==v||c!==d||l!==f||h!==p){let g=c*d+l*f+h*p+u*v;g<0&&(d=-d,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),M=Math.sin(y);m=Math.sin(m*y)/M,a=Math.sin(a*y)/M,c=c*m+d*a,l=l*m+f*a,h=h*m+p*a,u=u*m+v*a}else{c=c*m+d*a,l=l*m+f*a,h=h*m+p*a,u=u*m+v*a;let y=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=y,l*=y,h*=y,u*=y}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+c*f-l*d,e[t+1]=c*p+h*d+l*u-a*f,e[t+2]=l*p+h*f+a*d-c*u,e[t+3]=h*p-a*u-c*d-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),u=a(r/2),d=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"YZX":this._x=d*h*u+l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u-d*f*p;break;case"XZY":this._x=d*h*u-l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u+d*f*p;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(tg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(tg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return fd.copy(this).projectOnVector(e),this.sub(fd)}reflect(e){return this.sub(fd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},fd=new X,tg=new On,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],v=s[0],g=s[3],m=s[6],y=s[1],M=s[4],b=s[7],R=s[2],A=s[5],x=s[8];return r[0]=o*v+a*y+c*R,r[3]=o*g+a*M+c*A,r[6]=o*m+a*b+c*x,r[1]=l*v+h*y+u*R,r[4]=l*g+h*M+u*A,r[7]=l*m+h*b+u*x,r[2]=d*v+f*y+p*R,r[5]=d*g+f*M+p*A,r[8]=d*m+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=u*v,e[1]=(s*l-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(h*t-s*c)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*c-l*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Nr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(pd.makeScale(e,t)),this}rotate(e){return Nr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(pd.makeRotation(-e)),this}translate(e,t){return Nr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(pd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},pd=new st,ng=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ig=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _y(){let i={enabled:!0,workingColorSpace:ti,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=Us(s.r),s.g=Us(s.g),s.b=Us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Ro(s.r),s.g=Ro(s.g),s.b=Ro(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===$s?Ha:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ti]:{primaries:e,whitePoint:n,transfer:Ha,toXYZ:ng,fromXYZ:ig,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vn},outputColorSpaceConfig:{drawingBufferColorSpace:vn}},[vn]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:ng,fromXYZ:ig,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vn}}}),i}var mt=_y();function Us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ro(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var po,Uc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{po===void 0&&(po=Lo("canvas")),po.width=e.width,po.height=e.height;let s=po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=po}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Lo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Us(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Us(t[n]/255)*255):t[n]=Us(t[n]);return{data:t,width:e.width,height:e.height}}else return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},vy=0,Do=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:vy++}),this.uuid=vs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(md(s[o].image)):r.push(md(s[o]))}else r=md(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function md(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Uc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var yy=0,gd=new X,Un=class i extends Ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ii,s=Ii,r=bn,o=Oi,a=Ui,c=ci,l=i.DEFAULT_ANISOTROPY,h=$s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yy++}),this.uuid=vs(),this.name="",this.source=new Do(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(gd).x}get height(){return this.source.getSize(gd).y}get depth(){return this.source.getSize(gd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==uf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case hr:e.x=e.x-Math.floor(e.x);break;case Ii:e.x=e.x<0?0:1;break;case Po:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case hr:e.y=e.y-Math.floor(e.y);break;case Ii:e.y=e.y<0?0:1;break;case Po:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Un.DEFAULT_IMAGE=null;Un.DEFAULT_MAPPING=uf;Un.DEFAULT_ANISOTROPY=1;var Dt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],p=c[9],v=c[2],g=c[6],m=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(p+g)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(l+1)/2,b=(f+1)/2,R=(m+1)/2,A=(h+d)/4,x=(u+v)/4,E=(p+g)/4;return M>b&&M>R?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=A/n,r=x/n):b>R?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=A/s,r=E/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=E/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(u-v)/y,this.z=(d-h)/y,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fc=class extends Ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:bn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Dt(0,0,e,t),this.scissorTest=!1,this.viewport=new Dt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Un({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:bn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Do(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Fc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ga=class extends Un{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=an,this.minFilter=an,this.wrapR=Ii,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var kc=class extends Un{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=an,this.minFilter=an,this.wrapR=Ii,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ct=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g)}set(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/mo.setFromMatrixColumn(e,0).length(),r=1/mo.setFromMatrixColumn(e,1).length(),o=1/mo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=c*h,t[4]=-c*u,t[8]=l,t[1]=f+p*l,t[5]=d-v*l,t[9]=-a*c,t[2]=v-d*l,t[6]=p+f*l,t[10]=o*c}else if(e.order==="YXZ"){let d=c*h,f=c*u,p=l*h,v=l*u;t[0]=d+v*a,t[4]=p*a-f,t[8]=o*l,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=v+d*a,t[10]=o*c}else if(e.order==="ZXY"){let d=c*h,f=c*u,p=l*h,v=l*u;t[0]=d-v*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=c*h,t[4]=p*l-f,t[8]=d*l+v,t[1]=c*u,t[5]=v*l+d,t[9]=f*l-p,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let d=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*h,t[4]=v-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=f*u+p,t[10]=d-v*u}else if(e.order==="XZY"){let d=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*h,t[4]=-u,t[8]=l*h,t[1]=d*u+v,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(by,e,Sy)}lookAt(e,t,n){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),ir.crossVectors(n,gi),ir.lengthSq()===0&&(Math.abs(n.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),ir.crossVectors(n,gi)),ir.normalize(),nc.crossVectors(gi,ir),s[0]=ir.x,s[4]=nc.x,s[8]=gi.x,s[1]=ir.y,s[5]=nc.y,s[9]=gi.y,s[2]=ir.z,s[6]=nc.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],y=n[3],M=n[7],b=n[11],R=n[15],A=s[0],x=s[4],E=s[8],k=s[12],D=s[1],L=s[5],G=s[9],W=s[13],O=s[2],H=s[6],Y=s[10],B=s[14],ce=s[3],Z=s[7],ee=s[11],se=s[15];return r[0]=o*A+a*D+c*O+l*ce,r[4]=o*x+a*L+c*H+l*Z,r[8]=o*E+a*G+c*Y+l*ee,r[12]=o*k+a*W+c*B+l*se,r[1]=h*A+u*D+d*O+f*ce,r[5]=h*x+u*L+d*H+f*Z,r[9]=h*E+u*G+d*Y+f*ee,r[13]=h*k+u*W+d*B+f*se,r[2]=p*A+v*D+g*O+m*ce,r[6]=p*x+v*L+g*H+m*Z,r[10]=p*E+v*G+g*Y+m*ee,r[14]=p*k+v*W+g*B+m*se,r[3]=y*A+M*D+b*O+R*ce,r[7]=y*x+M*L+b*H+R*Z,r[11]=y*E+M*G+b*Y+R*ee,r[15]=y*k+M*W+b*B+R*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],y=c*f-l*d,M=a*f-l*u,b=a*d-c*u,R=o*f-l*h,A=o*d-c*h,x=o*u-a*h;return t*(v*y-g*M+m*b)-n*(p*y-g*R+m*A)+s*(p*M-v*R+m*x)-r*(p*b-v*A+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],y=t*a-n*o,M=t*c-s*o,b=t*l-r*o,R=n*c-s*a,A=n*l-r*a,x=s*l-r*c,E=h*v-u*p,k=h*g-d*p,D=h*m-f*p,L=u*g-d*v,G=u*m-f*v,W=d*m-f*g,O=y*W-M*G+b*L+R*D-A*k+x*E;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/O;return e[0]=(a*W-c*G+l*L)*H,e[1]=(s*G-n*W-r*L)*H,e[2]=(v*x-g*A+m*R)*H,e[3]=(d*A-u*x-f*R)*H,e[4]=(c*D-o*W-l*k)*H,e[5]=(t*W-s*D+r*k)*H,e[6]=(g*b-p*x-m*M)*H,e[7]=(h*x-d*b+f*M)*H,e[8]=(o*G-a*D+l*E)*H,e[9]=(n*D-t*G-r*E)*H,e[10]=(p*A-v*b+m*y)*H,e[11]=(u*b-h*A-f*y)*H,e[12]=(a*k-o*L-c*E)*H,e[13]=(t*L-n*k+s*E)*H,e[14]=(v*M-p*R-g*y)*H,e[15]=(h*R-u*M+d*y)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,p=r*u,v=o*h,g=o*u,m=a*u,y=c*l,M=c*h,b=c*u,R=n.x,A=n.y,x=n.z;return s[0]=(1-(v+m))*R,s[1]=(f+b)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(f-b)*A,s[5]=(1-(d+m))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(p+M)*x,s[9]=(g-y)*x,s[10]=(1-(d+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=mo.set(s[0],s[1],s[2]).length(),a=mo.set(s[4],s[5],s[6]).length(),c=mo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),qi.copy(this);let l=1/o,h=1/a,u=1/c;return qi.elements[0]*=l,qi.elements[1]*=l,qi.elements[2]*=l,qi.elements[4]*=h,qi.elements[5]*=h,qi.elements[6]*=h,qi.elements[8]*=u,qi.elements[9]*=u,qi.elements[10]*=u,t.setFromRotationMatrix(qi),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=Li,c=!1){let l=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(c)p=r/(o-r),v=o*r/(o-r);else if(a===Li)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Io)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Li,c=!1){let l=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(c)p=1/(o-r),v=o/(o-r);else if(a===Li)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Io)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},mo=new X,qi=new ct,by=new X(0,0,0),Sy=new X(1,1,1),ir=new X,nc=new X,gi=new X,sg=new ct,rg=new On,ks=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(gt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return sg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(sg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return rg.setFromEuler(this),this.setFromQuaternion(rg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ks.DEFAULT_ORDER="XYZ";var Oo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},My=0,og=new X,go=new On,Ps=new ct,ic=new X,Pa=new X,wy=new X,Ty=new On,ag=new X(1,0,0),lg=new X(0,1,0),cg=new X(0,0,1),hg={type:"added"},Ey={type:"removed"},xo={type:"childadded",child:null},xd={type:"childremoved",child:null},jt=class i extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=vs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new X,t=new ks,n=new On,s=new X(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ct},normalMatrix:{value:new st}}),this.matrix=new ct,this.matrixWorld=new ct,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.multiply(go),this}rotateOnWorldAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.premultiply(go),this}rotateX(e){return this.rotateOnAxis(ag,e)}rotateY(e){return this.rotateOnAxis(lg,e)}rotateZ(e){return this.rotateOnAxis(cg,e)}translateOnAxis(e,t){return og.copy(e).applyQuaternion(this.quaternion),this.position.add(og.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(ag,e)}translateY(e){return this.translateOnAxis(lg,e)}translateZ(e){return this.translateOnAxis(cg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ps.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ic.copy(e):ic.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Pa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ps.lookAt(Pa,ic,this.up):Ps.lookAt(ic,Pa,this.up),this.quaternion.setFromRotationMatrix(Ps),s&&(Ps.extractRotation(s.matrixWorld),go.setFromRotationMatrix(Ps),this.quaternion.premultiply(go.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(hg),xo.child=e,this.dispatchEvent(xo),xo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ey),xd.child=e,this.dispatchEvent(xd),xd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ps.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ps.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ps),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(hg),xo.child=e,this.dispatchEvent(xo),xo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,e,wy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,Ty,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(e.shapes,u)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};jt.DEFAULT_UP=new X(0,1,0);jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _i=class extends jt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ay={type:"move"},Uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _i,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _i,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _i,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(l,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ay)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new _i;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},w0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},sr={h:0,s:0,l:0},sc={h:0,s:0,l:0};function _d(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var je=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=mt.workingColorSpace){if(e=wf(e,1),t=gt(t,0,1),n=gt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=_d(o,r,e+1/3),this.g=_d(o,r,e),this.b=_d(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=vn){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vn){let n=w0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Us(e.r),this.g=Us(e.g),this.b=Us(e.b),this}copyLinearToSRGB(e){return this.r=Ro(e.r),this.g=Ro(e.g),this.b=Ro(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vn){return mt.workingToColorSpace(Xn.copy(this),e),Math.round(gt(Xn.r*255,0,255))*65536+Math.round(gt(Xn.g*255,0,255))*256+Math.round(gt(Xn.b*255,0,255))}getHexString(e=vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(Xn.copy(this),t);let n=Xn.r,s=Xn.g,r=Xn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-n)/u+2;break;case r:c=(n-s)/u+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(Xn.copy(this),t),e.r=Xn.r,e.g=Xn.g,e.b=Xn.b,e}getStyle(e=vn){mt.workingToColorSpace(Xn.copy(this),e);let t=Xn.r,n=Xn.g,s=Xn.b;return e!==vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(sr),this.setHSL(sr.h+e,sr.s+t,sr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(sr),e.getHSL(sc);let n=za(sr.h,sc.h,t),s=za(sr.s,sc.s,t),r=za(sr.l,sc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xn=new je;je.NAMES=w0;var Wa=class extends jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ks,this.environmentIntensity=1,this.environmentRotation=new ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new X,Is=new X,vd=new X,Ls=new X,_o=new X,vo=new X,ug=new X,yd=new X,bd=new X,Sd=new X,Md=new Dt,wd=new Dt,Td=new Dt,cr=class i{constructor(e=new X,t=new X,n=new X){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){$i.subVectors(s,t),Is.subVectors(n,t),vd.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Is),c=$i.dot(vd),l=Is.dot(Is),h=Is.dot(vd),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,p=(o*h-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ls)===null?!1:Ls.x>=0&&Ls.y>=0&&Ls.x+Ls.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,Ls)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Ls.x),c.addScaledVector(o,Ls.y),c.addScaledVector(a,Ls.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return Md.setScalar(0),wd.setScalar(0),Td.setScalar(0),Md.fromBufferAttribute(e,t),wd.fromBufferAttribute(e,n),Td.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Md,r.x),o.addScaledVector(wd,r.y),o.addScaledVector(Td,r.z),o}static isFrontFacing(e,t,n,s){return $i.subVectors(n,t),Is.subVectors(e,t),$i.cross(Is).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Is.subVectors(this.a,this.b),$i.cross(Is).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;_o.subVectors(s,n),vo.subVectors(r,n),yd.subVectors(e,n);let c=_o.dot(yd),l=vo.dot(yd);if(c<=0&&l<=0)return t.copy(n);bd.subVectors(e,s);let h=_o.dot(bd),u=vo.dot(bd);if(h>=0&&u<=h)return t.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(n).addScaledVector(_o,o);Sd.subVectors(e,r);let f=_o.dot(Sd),p=vo.dot(Sd);if(p>=0&&f<=p)return t.copy(r);let v=f*l-c*p;if(v<=0&&l>=0&&p<=0)return a=l/(l-p),t.copy(n).addScaledVector(vo,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return ug.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(ug,a);let m=1/(g+v+d);return o=v*m,a=d*m,t.copy(n).addScaledVector(_o,o).addScaledVector(vo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},qn=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Yi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Yi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Yi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Yi):Yi.fromBufferAttribute(r,o),Yi.applyMatrix4(e.matrixWorld),this.expandByPoint(Yi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),rc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),rc.copy(n.boundingBox)),rc.applyMatrix4(e.matrixWorld),this.union(rc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Yi),Yi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ia),oc.subVectors(this.max,Ia),yo.subVectors(e.a,Ia),bo.subVectors(e.b,Ia),So.subVectors(e.c,Ia),rr.subVectors(bo,yo),or.subVectors(So,bo),Cr.subVectors(yo,So);let t=[0,-rr.z,rr.y,0,-or.z,or.y,0,-Cr.z,Cr.y,rr.z,0,-rr.x,or.z,0,-or.x,Cr.z,0,-Cr.x,-rr.y,rr.x,0,-or.y,or.x,0,-Cr.y,Cr.x,0];return!Ed(t,yo,bo,So,oc)||(t=[1,0,0,0,1,0,0,0,1],!Ed(t,yo,bo,So,oc))?!1:(ac.crossVectors(rr,or),t=[ac.x,ac.y,ac.z],Ed(t,yo,bo,So,oc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Yi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Yi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ns[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ns[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ns[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ns[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ns[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ns[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ns[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ns[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ns),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ns=[new X,new X,new X,new X,new X,new X,new X,new X],Yi=new X,rc=new qn,yo=new X,bo=new X,So=new X,rr=new X,or=new X,Cr=new X,Ia=new X,oc=new X,ac=new X,Pr=new X;function Ed(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Pr.fromArray(i,r);let a=s.x*Math.abs(Pr.x)+s.y*Math.abs(Pr.y)+s.z*Math.abs(Pr.z),c=e.dot(Pr),l=t.dot(Pr),h=n.dot(Pr);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var mn=new X,lc=new Ke,Ry=0,zn=class extends Ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ry++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Sf,this.updateRanges=[],this.gpuType=yi,this.version=0,this._normalizationScale=e!==void 0?zh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)lc.fromBufferAttribute(this,t),lc.applyMatrix3(e),this.setXY(t,lc.x,lc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ef(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Af(e,this.array)}};var Xa=class extends zn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var qa=class extends zn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Dn=class extends zn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Cy=new qn,La=new X,Ad=new X,oi=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Cy.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;La.subVectors(e,this.center);let t=La.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(La,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ad.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(La.copy(e.center).add(Ad)),this.expandByPoint(La.copy(e.center).sub(Ad))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Py=0,Pi=new ct,Rd=new jt,Mo=new X,xi=new qn,Na=new qn,Nn=new X,ni=class i extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Py++}),this.uuid=vs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ty(e)?qa:Xa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,n){return Pi.makeTranslation(e,t,n),this.applyMatrix4(Pi),this}scale(e,t,n){return Pi.makeScale(e,t,n),this.applyMatrix4(Pi),this}lookAt(e){return Rd.lookAt(e),Rd.updateMatrix(),this.applyMatrix4(Rd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Dn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new oi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let n=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Na.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(xi.min,Na.min),xi.expandByPoint(Nn),Nn.addVectors(xi.max,Na.max),xi.expandByPoint(Nn)):(xi.expandByPoint(Na.min),xi.expandByPoint(Na.max))}xi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Nn.fromBufferAttribute(a,l),c&&(Mo.fromBufferAttribute(e,l),Nn.add(Mo)),s=Math.max(s,n.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new zn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new X,c[k]=new X;let h=new X,u=new X,d=new X,f=new Ke,p=new Ke,v=new Ke,g=new X,m=new X;function y(k,D,L){l[k]=l[D]=l[L]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,D),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,D),v.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),v.sub(f);let G=1/(p.x*v.y-v.x*p.y);isFinite(G)&&(g.copy(u).multiplyScalar(v.y).addScaledVector(d,-p.y).multiplyScalar(G),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(G),a[k].add(g),a[D].add(g),a[L].add(g),c[k].add(m),c[D].add(m),c[L].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let k=0,D=M.length;k<D;++k){let L=M[k],G=L.start,W=L.count;for(let O=G,H=G+W;O<H;O+=3)y(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let b=new X,R=new X,A=new X,x=new X;function E(k){A.fromBufferAttribute(s,k),x.copy(A);let D=a[k];b.copy(D),b.sub(A.multiplyScalar(A.dot(D))).normalize(),R.crossVectors(x,D);let G=R.dot(c[k])<0?-1:1;o.setXYZW(k,b.x,b.y,b.z,G)}for(let k=0,D=n.count;k<D;++k)l[k]&&E(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new zn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new X,r=new X,o=new X,a=new X,c=new X,l=new X,h=new X,u=new X;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),v=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,v),l.fromBufferAttribute(n,g),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,c.x,c.y,c.z),n.setXYZ(g,l.x,l.y,l.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,p=0;for(let v=0,g=c.length;v<g;v++){a.isInterleavedBufferAttribute?f=c[v]*a.data.stride+a.offset:f=c[v]*h;for(let m=0;m<h;m++)d[p++]=l[f++]}return new zn(d,h,u)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=e(d,n);c.push(f)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(e.data))}h.length>0&&(s[c]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(t))}let r=e.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fo=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Sf,this.updateRanges=[],this.version=0,this.uuid=vs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=dg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=dg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function dg(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=vs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ei=new X,ko=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?zh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ei.fromBufferAttribute(this,t),ei.applyMatrix4(e),this.setXYZ(t,ei.x,ei.y,ei.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ei.fromBufferAttribute(this,t),ei.applyNormalMatrix(e),this.setXYZ(t,ei.x,ei.y,ei.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ei.fromBufferAttribute(this,t),ei.transformDirection(e),this.setXYZ(t,ei.x,ei.y,ei.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Va("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new zn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Va("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ef(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Af(e,this.data.array)}},Cd=new X,Iy=new X,Ly=new st,Bn=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Cd.subVectors(n,t).cross(Iy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Cd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Ly.getNormalMatrix(e),s=this.coplanarPoint(Cd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ny=0,ai=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ny++}),this.uuid=vs(),this.name="",this.type="Material",this.blending=Ko,this.side=xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ef,this.blendDst=tf,this.blendEquation=Gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=Co,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=p0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Rc,this.stencilZFail=Rc,this.stencilZPass=Rc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Bn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ke().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ds=new X,Pd=new X,cc=new X,hc=new X,fs=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ds)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ds.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ds.copy(this.origin).addScaledVector(this.direction,t),Ds.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Pd.copy(e).add(t).multiplyScalar(.5),cc.copy(t).sub(e).normalize(),hc.copy(this.origin).sub(Pd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(cc),a=hc.dot(this.direction),c=-hc.dot(cc),l=hc.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*c-a,d=o*a-c,p=r*h,u>=0)if(d>=-p)if(d<=p){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=p?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Pd).addScaledVector(cc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ds.subVectors(e.center,this.origin);let n=Ds.dot(this.direction),s=Ds.dot(Ds)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(n=(e.min.x-d.x)*l,s=(e.max.x-d.x)*l):(n=(e.max.x-d.x)*l,s=(e.min.x-d.x)*l),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,c=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,c=(e.min.z-d.z)*u),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ds)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,y=n.y-o.y,M=n.z-o.z,b=Math.abs(c),R=Math.abs(l),A=Math.abs(h),x,E,k,D,L,G,W,O,H,Y,B,ce;if(b>=R&&b>=A?(k=c,G=u,H=p,ce=m,c>=0?(x=l,E=h,D=d,L=f,W=v,O=g,Y=y,B=M):(x=h,E=l,D=f,L=d,W=g,O=v,Y=M,B=y)):R>=A?(k=l,G=d,H=v,ce=y,l>=0?(x=h,E=c,D=f,L=u,W=g,O=p,Y=M,B=m):(x=c,E=h,D=u,L=f,W=p,O=g,Y=m,B=M)):(k=h,G=f,H=g,ce=M,h>=0?(x=c,E=l,D=u,L=d,W=p,O=v,Y=m,B=y):(x=l,E=c,D=d,L=u,W=v,O=p,Y=y,B=m)),k===0)return null;let Z=x/k,ee=E/k,se=1/k,fe=D-Z*G,de=L-ee*G,te=W-Z*H,ge=O-ee*H,ve=Y-Z*ce,Re=B-ee*ce,Me=ve*ge-Re*te,$e=fe*Re-de*ve,at=te*de-ge*fe;if(s){if(Me<0||$e<0||at<0)return null}else if((Me<0||$e<0||at<0)&&(Me>0||$e>0||at>0))return null;let We=Me+$e+at;if(We===0)return null;let pt=se*(Me*G+$e*H+at*ce);return(We>0?pt<0:pt>0)?null:this.at(pt/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ni=class extends ai{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=nf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},fg=new ct,Ir=new fs,uc=new oi,pg=new X,dc=new X,fc=new X,pc=new X,Id=new X,mc=new X,mg=new X,gc=new X,ln=class extends jt{constructor(e=new ni,t=new Ni){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){mc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Id.fromBufferAttribute(u,e),o?mc.addScaledVector(Id,h):mc.addScaledVector(Id.sub(t),h))}t.add(mc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),uc.copy(n.boundingSphere),uc.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(uc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(uc,pg)===null||Ir.origin.distanceToSquared(pg)>(e.far-e.near)**2))&&(fg.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(fg),!(n.boundingBox!==null&&Ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let A=a.getX(b),x=a.getX(b+1),E=a.getX(b+2);s=xc(this,m,e,n,l,h,u,A,x,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=xc(this,o,e,n,l,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let A=b,x=b+1,E=b+2;s=xc(this,m,e,n,l,h,u,A,x,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(c.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=g,M=g+1,b=g+2;s=xc(this,o,e,n,l,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function Dy(i,e,t,n,s,r,o,a){let c;if(e.side===si?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===xs,a),c===null)return null;gc.copy(a),gc.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(gc);return l<t.near||l>t.far?null:{distance:l,point:gc.clone(),object:i}}function xc(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,dc),i.getVertexPosition(c,fc),i.getVertexPosition(l,pc);let h=Dy(i,e,t,n,dc,fc,pc,mg);if(h){let u=new X;cr.getBarycoord(mg,dc,fc,pc,u),s&&(h.uv=cr.getInterpolatedAttribute(s,a,c,l,u,new Ke)),r&&(h.uv1=cr.getInterpolatedAttribute(r,a,c,l,u,new Ke)),o&&(h.normal=cr.getInterpolatedAttribute(o,a,c,l,u,new X),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new X,materialIndex:0};cr.getNormal(dc,fc,pc,d.normal),h.face=d,h.barycoord=u}return h}var Da=new Dt,gg=new Dt,xg=new Dt,Oy=new Dt,_g=new ct,_c=new X,Ld=new oi,vg=new ct,Nd=new fs,$a=class extends ln{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Fd,this.bindMatrix=new ct,this.bindMatrixInverse=new ct,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new qn),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,_c),this.boundingBox.expandByPoint(_c)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new oi),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,_c),this.boundingSphere.expandByPoint(_c)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ld.copy(this.boundingSphere),Ld.applyMatrix4(s),e.ray.intersectsSphere(Ld)!==!1&&(vg.copy(s).invert(),Nd.copy(e.ray).applyMatrix4(vg),!(this.boundingBox!==null&&Nd.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,Nd)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new Dt,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Fd?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===h0?this.bindMatrixInverse.copy(this.bindMatrix).invert():qe("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;gg.fromBufferAttribute(s.attributes.skinIndex,e),xg.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(Da.copy(t),t.set(0,0,0,0)):(Da.set(t.x,t.y,t.z,1),t.set(0,0,0)),Da.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=xg.getComponent(r);if(o!==0){let a=gg.getComponent(r);_g.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(Oy.copy(Da).applyMatrix4(_g),o)}}return t.isVector4&&(t.w=Da.w),t.applyMatrix4(this.bindMatrixInverse)}},Bo=class extends jt{constructor(){super(),this.isBone=!0,this.type="Bone"}},zo=class extends Un{constructor(e=null,t=1,n=1,s,r,o,a,c,l=an,h=an,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},yg=new ct,Uy=new ct,Ya=class i{constructor(e=[],t=[]){this.uuid=vs(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){qe("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new ct)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new ct;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:Uy;yg.multiplyMatrices(a,t[r]),yg.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new zo(t,e,e,Ui,yi);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(qe("Skeleton: No bone found with UUID:",r),o=new Bo),this.bones.push(o),this.boneInverses.push(new ct().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},Bs=class extends zn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},wo=new ct,bg=new ct,vc=[],Sg=new qn,Fy=new ct,Oa=new ln,Ua=new oi,Ka=class extends ln{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Bs(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Fy)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new qn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,wo),Sg.copy(e.boundingBox).applyMatrix4(wo),this.boundingBox.union(Sg)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new oi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,wo),Ua.copy(e.boundingSphere).applyMatrix4(wo),this.boundingSphere.union(Ua)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Oa.geometry=this.geometry,Oa.material=this.material,Oa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ua.copy(this.boundingSphere),Ua.applyMatrix4(n),e.ray.intersectsSphere(Ua)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,wo),bg.multiplyMatrices(n,wo),Oa.matrixWorld=bg,Oa.raycast(e,vc);for(let o=0,a=vc.length;o<a;o++){let c=vc[o];c.instanceId=r,c.object=this,t.push(c)}vc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Bs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new zo(new Float32Array(s*this.count),s,this.count,rh,yi));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*e;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Lr=new oi,ky=new Ke(.5,.5),yc=new X,ur=class{constructor(e=new Bn,t=new Bn,n=new Bn,s=new Bn,r=new Bn,o=new Bn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Li,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],y=r[12],M=r[13],b=r[14],R=r[15];if(s[0].setComponents(l-o,f-h,m-p,R-y).normalize(),s[1].setComponents(l+o,f+h,m+p,R+y).normalize(),s[2].setComponents(l+a,f+u,m+v,R+M).normalize(),s[3].setComponents(l-a,f-u,m-v,R-M).normalize(),n)s[4].setComponents(c,d,g,b).normalize(),s[5].setComponents(l-c,f-d,m-g,R-b).normalize();else if(s[4].setComponents(l-c,f-d,m-g,R-b).normalize(),t===Li)s[5].setComponents(l+c,f+d,m+g,R+b).normalize();else if(t===Io)s[5].setComponents(c,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(e){Lr.center.set(0,0,0);let t=ky.distanceTo(e.center);return Lr.radius=.7071067811865476+t,Lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(yc.x=s.normal.x>0?e.max.x:e.min.x,yc.y=s.normal.y>0?e.max.y:e.min.y,yc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(yc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Mg=new ct,Bc=class i{constructor(){this.coordinateSystem=Li,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Mg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ur),n[s].setFromProjectionMatrix(Mg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ur),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ho=class extends ai{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},zc=new X,Hc=new X,wg=new ct,Fa=new fs,bc=new oi,Dd=new X,Tg=new X,Fr=class extends jt{constructor(e=new ni,t=new Ho){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)zc.fromBufferAttribute(t,s-1),Hc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=zc.distanceTo(Hc);e.setAttribute("lineDistance",new Dn(n,1))}else qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),bc.copy(n.boundingSphere),bc.applyMatrix4(s),bc.radius+=r,e.ray.intersectsSphere(bc)===!1)return;wg.copy(s).invert(),Fa.copy(e.ray).applyMatrix4(wg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=l){let m=h.getX(v),y=h.getX(v+1),M=Sc(this,e,Fa,c,m,y,v);M&&t.push(M)}if(this.isLineLoop){let v=h.getX(p-1),g=h.getX(f),m=Sc(this,e,Fa,c,v,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=l){let m=Sc(this,e,Fa,c,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=Sc(this,e,Fa,c,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Sc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(zc.fromBufferAttribute(a,s),Hc.fromBufferAttribute(a,r),t.distanceSqToSegment(zc,Hc,Dd,Tg)>n)return;Dd.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Dd);if(!(l<e.near||l>e.far))return{distance:l,point:Tg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Eg=new X,Ag=new X,ja=class extends Fr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Eg.fromBufferAttribute(t,s),Ag.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Eg.distanceTo(Ag);e.setAttribute("lineDistance",new Dn(n,1))}else qe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Za=class extends Fr{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Vo=class extends ai{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new je(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Rg=new ct,Vd=new fs,Mc=new oi,wc=new X,Ja=class extends jt{constructor(e=new ni,t=new Vo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Mc.copy(n.boundingSphere),Mc.applyMatrix4(s),Mc.radius+=r,e.ray.intersectsSphere(Mc)===!1)return;Rg.copy(s).invert(),Vd.copy(e.ray).applyMatrix4(Rg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=n.index,u=n.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let p=d,v=f;p<v;p++){let g=l.getX(p);wc.fromBufferAttribute(u,g),Cg(wc,g,c,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,v=f;p<v;p++)wc.fromBufferAttribute(u,p),Cg(wc,p,c,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cg(i,e,t,n,s,r,o){let a=Vd.distanceSqToPoint(i);if(a<t){let c=new X;Vd.closestPointToPoint(i,c),c.applyMatrix4(n);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Qa=class extends Un{constructor(e=[],t=Wr,n,s,r,o,a,c,l,h){super(e,t,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var zs=class extends Un{constructor(e,t,n=ji,s,r,o,a=an,c=an,l,h=Fs,u=1){if(h!==Fs&&h!==qs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Do(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},el=class extends zs{constructor(e,t=ji,n=Wr,s,r,o=an,a=an,c,l=Fs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},tl=class extends Un{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Go=class i extends ni{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new Dn(l,3)),this.setAttribute("normal",new Dn(h,3)),this.setAttribute("uv",new Dn(u,2));function p(v,g,m,y,M,b,R,A,x,E,k){let D=b/x,L=R/E,G=b/2,W=R/2,O=A/2,H=x+1,Y=E+1,B=0,ce=0,Z=new X;for(let ee=0;ee<Y;ee++){let se=ee*L-W;for(let fe=0;fe<H;fe++){let de=fe*D-G;Z[v]=de*y,Z[g]=se*M,Z[m]=O,l.push(Z.x,Z.y,Z.z),Z[v]=0,Z[g]=0,Z[m]=A>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(fe/x),u.push(1-ee/E),B+=1}}for(let ee=0;ee<E;ee++)for(let se=0;se<x;se++){let fe=d+se+H*ee,de=d+se+H*(ee+1),te=d+(se+1)+H*(ee+1),ge=d+(se+1)+H*ee;c.push(fe,de,ge),c.push(de,te,ge),ce+=6}a.addGroup(f,ce,k),f+=ce,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var nl=class i extends ni{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,u=e/a,d=t/c,f=[],p=[],v=[],g=[];for(let m=0;m<h;m++){let y=m*d-o;for(let M=0;M<l;M++){let b=M*u-r;p.push(b,-y,0),v.push(0,0,1),g.push(M/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let y=0;y<a;y++){let M=y+l*m,b=y+l*(m+1),R=y+1+l*(m+1),A=y+1+l*m;f.push(M,b,A),f.push(b,R,A)}this.setIndex(f),this.setAttribute("position",new Dn(p,3)),this.setAttribute("normal",new Dn(v,3)),this.setAttribute("uv",new Dn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var il=class i extends ni{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new X,d=new X,f=[],p=[],v=[],g=[];for(let m=0;m<=n;m++){let y=[],M=m/n,b=o+M*a,R=e*Math.cos(b),A=Math.sqrt(e*e-R*R),x=0;m===0&&o===0?x=.5/t:m===n&&c===Math.PI&&(x=-.5/t);for(let E=0;E<=t;E++){let k=E/t,D=s+k*r;u.x=-A*Math.cos(D),u.y=R,u.z=A*Math.sin(D),p.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),g.push(k+x,1-M),y.push(l++)}h.push(y)}for(let m=0;m<n;m++)for(let y=0;y<t;y++){let M=h[m][y+1],b=h[m][y],R=h[m+1][y],A=h[m+1][y+1];(m!==0||o>0)&&f.push(M,b,A),(m!==n-1||c<Math.PI)&&f.push(b,R,A)}this.setIndex(f),this.setAttribute("position",new Dn(p,3)),this.setAttribute("normal",new Dn(v,3)),this.setAttribute("uv",new Dn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function $r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Pg(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Pg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function $n(i){let e={};for(let t=0;t<i.length;t++){let n=$r(i[t]);for(let s in n)e[s]=n[s]}return e}function Pg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function By(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Rf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var T0={clone:$r,merge:$n},zy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ps=class extends ai{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=zy,this.fragmentShader=Hy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=$r(e.uniforms),this.uniformsGroups=By(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new je().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Dt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ct().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Vc=class extends ps{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},kr=class extends ai{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new je(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Bh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},ii=class extends kr{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new Ke(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return gt(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new je(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new je(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new je(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Nr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Nr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var Gc=class extends ai{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=d0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Wc=class extends ai{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function lr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function ka(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function Vy(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function Ig(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let c=0;c!==e;++c)s[o++]=i[a+c]}return s}function Gy(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var ms=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xc=class extends ms{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Bd,endingEnd:Bd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case zd:r=e,a=2*t-n;break;case Hd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case zd:o=e,c=2*n-t;break;case Hd:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,h=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,g=v*p,m=-d*g+2*d*v-d*p,y=(1+d)*g+(-1.5-2*d)*v+(-.5+d)*p+1,M=(-1-f)*g+(1.5+f)*v+.5*p,b=f*g-f*v;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+y*o[l+R]+M*o[c+R]+b*o[u+R];return r}},qc=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},$c=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Yc=class extends ms{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[l+g]*v+o[c+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[l+p],g=o[c+p],m=f*d+p*2,y=u[m],M=u[m+1],b=e*d+p*2,R=h[b],A=h[b+1],x=Xy(n,t,y,R,s);r[p]=E0(x,v,M,A,g)}return r}};function E0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Wy(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Xy(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=E0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=Wy(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=lr(t,this.TimeBufferType),this.values=lr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:lr(e.times,Array),values:lr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),ka(e.settings)&&(n.settings={inTangents:lr(e.settings.inTangents,Array),outTangents:lr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new $c(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Xc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Yc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Dr:t=this.InterpolantFactoryMethodDiscrete;break;case Or:t=this.InterpolantFactoryMethodLinear;break;case Ac:t=this.InterpolantFactoryMethodSmooth;break;case kd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Dr;case this.InterpolantFactoryMethodLinear:return Or;case this.InterpolantFactoryMethodSmooth:return Ac;case this.InterpolantFactoryMethodBezier:return kd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;ka(this.settings)&&(Lg(this.settings.inTangents,e),Lg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;ka(this.settings)&&(Ng(this.settings.inTangents,e),Ng(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){nt("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){nt("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&ny(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){nt("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ac,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],h=e[a+1];if(l!==h&&(a!==1||l!==e[0]))if(s)c=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let v=t[u+p];if(v!==t[d+p]||v!==t[f+p]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,ka(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Lg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Ng(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=Or;var Hs=class extends li{constructor(e,t,n){super(e,t,n)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=Dr;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var sl=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};sl.prototype.ValueTypeName="color";var Vs=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Vs.prototype.ValueTypeName="number";var Kc=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let h=l+a;l!==h;l+=4)On.slerpFlat(r,0,o,l-a,o,l,c);return r}},Gs=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Kc(this.times,this.values,this.getValueSize(),e)}};Gs.prototype.ValueTypeName="quaternion";Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ws=class extends li{constructor(e,t,n){super(e,t,n)}};Ws.prototype.ValueTypeName="string";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=Dr;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var dr=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};dr.prototype.ValueTypeName="vector";var rl=class{constructor(e="",t=-1,n=[],s=u0){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=vs(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push($y(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(li.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let c=[],l=[];c.push((a+r-1)%r,a,(a+1)%r),l.push(0,1,0);let h=Vy(c);c=Ig(c,1,h),l=Ig(l,1,h),!s&&c[0]===0&&(c.push(r),l.push(l[0])),o.push(new Vs(".morphTargetInfluences["+t[a].name+"]",c,l).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,c=e.length;a<c;a++){let l=e[a],h=l.name.match(r);if(h&&h.length>1){let u=h[1],d=s[u];d||(s[u]=d=[]),d.push(l)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function qy(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Vs;case"vector":case"vector2":case"vector3":case"vector4":return dr;case"color":return sl;case"quaternion":return Gs;case"bool":case"boolean":return Hs;case"string":return Ws}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function $y(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=qy(i.type);if(i.times===void 0){let n=[],s=[];Gy(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),ka(i.settings)&&(t.settings={inTangents:lr(i.settings.inTangents,Float32Array),outTangents:lr(i.settings.outTangents,Float32Array)}),t}var ds={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(Dg(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!Dg(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function Dg(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var jc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],p=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},A0=new jc,gs=class{constructor(e){this.manager=e!==void 0?e:A0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};gs.DEFAULT_MATERIAL_NAME="__DEFAULT";var Os={},Gd=class extends Error{constructor(e,t){super(e),this.response=t}},Wo=class extends gs{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=ds.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Os[e]!==void 0){Os[e].push({onLoad:t,onProgress:n,onError:s});return}Os[e]=[],Os[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,c=this.responseType;fetch(o).then(l=>{if(l.status===200||l.status===0){if(l.status===0&&qe("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||l.body===void 0||l.body.getReader===void 0)return l;let h=Os[e],u=l.body.getReader(),d=l.headers.get("X-File-Size")||l.headers.get("Content-Length"),f=d?parseInt(d):0,p=f!==0,v=0,g=new ReadableStream({start(m){y();function y(){u.read().then(({done:M,value:b})=>{if(M)m.close();else{v+=b.byteLength;let R=new ProgressEvent("progress",{lengthComputable:p,loaded:v,total:f});for(let A=0,x=h.length;A<x;A++){let E=h[A];E.onProgress&&E.onProgress(R)}m.enqueue(b),y()}},M=>{m.error(M)})}}});return new Response(g)}else throw new Gd(`fetch for "${l.url}" responded with ${l.status}: ${l.statusText}`,l)}).then(l=>{switch(c){case"arraybuffer":return l.arrayBuffer();case"blob":return l.blob();case"document":return l.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return l.json();default:if(a==="")return l.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),d=u&&u[1]?u[1].toLowerCase():void 0,f=new TextDecoder(d);return l.arrayBuffer().then(p=>f.decode(p))}}}).then(l=>{ds.add(`file:${e}`,l);let h=Os[e];delete Os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onLoad&&f.onLoad(l)}}).catch(l=>{let h=Os[e];if(h===void 0)throw this.manager.itemError(e),l;delete Os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onError&&f.onError(l)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var To=new WeakMap,Zc=class extends gs{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=ds.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let u=To.get(o);u===void 0&&(u=[],To.set(o,u)),u.push({onLoad:t,onError:s})}return o}let a=Lo("img");function c(){h(),t&&t(this);let u=To.get(this)||[];for(let d=0;d<u.length;d++){let f=u[d];f.onLoad&&f.onLoad(this)}To.delete(this),r.manager.itemEnd(e)}function l(u){h(),s&&s(u),ds.remove(`image:${e}`);let d=To.get(this)||[];for(let f=0;f<d.length;f++){let p=d[f];p.onError&&p.onError(u)}To.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function h(){a.removeEventListener("load",c,!1),a.removeEventListener("error",l,!1)}return a.addEventListener("load",c,!1),a.addEventListener("error",l,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),ds.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var ol=class extends gs{constructor(e){super(e)}load(e,t,n,s){let r=new Un,o=new Zc(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},fr=class extends jt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},al=class extends fr{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Od=new ct,Og=new X,Ug=new X,Xo=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=ci,this.map=null,this.mapPass=null,this.matrix=new ct,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ur,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Dt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Og.setFromMatrixPosition(e.matrixWorld),t.position.copy(Og),Ug.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Ug),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Od.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Od,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===Io||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Od)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Tc=new X,Ec=new On,us=new X,ll=class extends jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ct,this.projectionMatrix=new ct,this.projectionMatrixInverse=new ct,this.coordinateSystem=Li,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Tc,Ec,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tc,Ec,us.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Tc,Ec,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tc,Ec,us.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ar=new X,Fg=new Ke,kg=new Ke,yn=class extends ll{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ur*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ba*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ur*2*Math.atan(Math.tan(Ba*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ar.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ar.x,ar.y).multiplyScalar(-e/ar.z),ar.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ar.x,ar.y).multiplyScalar(-e/ar.z)}getViewSize(e,t){return this.getViewBounds(e,Fg,kg),t.subVectors(kg,Fg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ba*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Wd=class extends Xo{constructor(){super(new yn(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Ur*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},cl=class extends fr{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.target=new jt,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new Wd}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},Xd=class extends Xo{constructor(){super(new yn(90,1,.5,500)),this.isPointLightShadow=!0}},hl=class extends fr{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new Xd}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Br=class extends ll{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},qd=class extends Xo{constructor(){super(new Br(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},zr=class extends fr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.target=new jt,this.shadow=new qd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},ul=class extends fr{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Xs=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}};var Ud=new WeakMap,dl=class extends gs{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&qe("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&qe("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=ds.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(l=>{Ud.has(o)===!0?(s&&s(Ud.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(l),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let c=fetch(e,a).then(function(l){return l.blob()}).then(function(l){return createImageBitmap(l,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(l){return ds.add(`image-bitmap:${e}`,l),t&&t(l),r.manager.itemEnd(e),l}).catch(function(l){s&&s(l),Ud.set(c,l),ds.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});ds.add(`image-bitmap:${e}`,c),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Eo=-90,Ao=1,qo=class extends jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new yn(Eo,Ao,e,t);s.layers=this.layers,this.add(s);let r=new yn(Eo,Ao,e,t);r.layers=this.layers,this.add(r);let o=new yn(Eo,Ao,e,t);o.layers=this.layers,this.add(o);let a=new yn(Eo,Ao,e,t);a.layers=this.layers,this.add(a);let c=new yn(Eo,Ao,e,t);c.layers=this.layers,this.add(c);let l=new yn(Eo,Ao,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===Li)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Io)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Jc=class extends yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Cf="\\[\\]\\.:\\/",Yy=new RegExp("["+Cf+"]","g"),Pf="[^"+Cf+"]",Ky="[^"+Cf.replace("\\.","")+"]",jy=/((?:WC+[\/:])*)/.source.replace("WC",Pf),Zy=/(WCOD+)?/.source.replace("WCOD",Ky),Jy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Pf),Qy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Pf),eb=new RegExp("^"+jy+Zy+Jy+Qy+"$"),tb=["material","materials","bones","map"],$d=class{constructor(e,t,n){let s=n||kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Yy,"")}static parseTrackName(e){let t=eb.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);tb.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===l){l=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};kt.Composite=$d;kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};kt.prototype.GetterByBindingType=[kt.prototype._getValue_direct,kt.prototype._getValue_array,kt.prototype._getValue_arrayElement,kt.prototype._getValue_toArray];kt.prototype.SetterByBindingTypeAndVersioning=[[kt.prototype._setValue_direct,kt.prototype._setValue_direct_setNeedsUpdate,kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_array,kt.prototype._setValue_array_setNeedsUpdate,kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_arrayElement,kt.prototype._setValue_arrayElement_setNeedsUpdate,kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_fromArray,kt.prototype._setValue_fromArray_setNeedsUpdate,kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var KA=new Float32Array(1);var Bg=new ct,Hr=class{constructor(e,t,n=0,s=1/0){this.ray=new fs(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Oo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Bg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Bg),this}intersectObject(e,t=!0,n=[]){return Yd(e,this,n,t),n.sort(zg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Yd(e[s],this,n,t);return n.sort(zg),n}};function zg(i,e){return i.distance-e.distance}function Yd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Yd(r[o],e,t,!0)}}var $o=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=gt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(gt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Kd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var fl=class extends Ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function If(i,e,t,n){let s=nb(n);switch(t){case gf:return i*e;case rh:return i*e/s.components*s.byteLength;case oh:return i*e/s.components*s.byteLength;case gr:return i*e*2/s.components*s.byteLength;case ah:return i*e*2/s.components*s.byteLength;case xf:return i*e*3/s.components*s.byteLength;case Ui:return i*e*4/s.components*s.byteLength;case lh:return i*e*4/s.components*s.byteLength;case ml:case gl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xl:case _l:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case hh:case dh:return Math.max(i,16)*Math.max(e,8)/4;case ch:case uh:return Math.max(i,8)*Math.max(e,8)/2;case fh:case ph:case gh:case xh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case mh:case vl:case _h:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case vh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case bh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Sh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Mh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case wh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Th:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Eh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ah:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Rh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ch:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Ph:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Ih:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Lh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Nh:case Dh:case Oh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Uh:case Fh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case yl:case kh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function nb(i){switch(i){case ci:case df:return{byteLength:1,components:1};case Jo:case ff:case Zi:return{byteLength:2,components:1};case ih:case sh:return{byteLength:2,components:4};case ji:case nh:case yi:return{byteLength:4,components:1};case pf:case mf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function K0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function sb(i){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(i.bindBuffer(l,a),u.length===0)i.bufferSubData(l,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],v=u[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let v=u[f];i.bufferSubData(l,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var rb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ob=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,ab=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,lb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,cb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,hb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ub=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,db=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,fb=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,pb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,mb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,gb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,xb=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,_b=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,vb=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,yb=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,bb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Sb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Mb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,wb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Tb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ab=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Rb=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Cb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Pb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ib=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Lb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Nb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Db="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ob=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ub=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Fb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,kb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Bb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,zb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Hb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Vb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Wb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Xb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,qb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,$b=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Yb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Kb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,jb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Zb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Jb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Qb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,eS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,tS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,nS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,iS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,sS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,rS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,oS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,aS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,lS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,uS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,dS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,fS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,pS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,gS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,xS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,_S=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,vS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,bS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,SS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,MS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,wS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,TS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ES=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,AS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,RS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,CS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,PS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,IS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,LS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,NS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,DS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,OS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,US=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,FS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,kS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,BS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,zS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,HS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,VS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,GS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,WS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,XS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,qS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,$S=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,YS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,KS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ZS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,JS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,QS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,eM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,tM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,nM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,iM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,sM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,rM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,aM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,uM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,dM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,fM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,pM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,mM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,xM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,_M=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,vM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,bM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,MM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,TM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,EM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,AM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,RM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,CM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,IM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,LM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,NM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,FM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:rb,alphahash_pars_fragment:ob,alphamap_fragment:ab,alphamap_pars_fragment:lb,alphatest_fragment:cb,alphatest_pars_fragment:hb,aomap_fragment:ub,aomap_pars_fragment:db,batching_pars_vertex:fb,batching_vertex:pb,begin_vertex:mb,beginnormal_vertex:gb,bsdfs:xb,iridescence_fragment:_b,bumpmap_pars_fragment:vb,clipping_planes_fragment:yb,clipping_planes_pars_fragment:bb,clipping_planes_pars_vertex:Sb,clipping_planes_vertex:Mb,color_fragment:wb,color_pars_fragment:Tb,color_pars_vertex:Eb,color_vertex:Ab,common:Rb,defaultnormal_vertex:Cb,displacementmap_pars_vertex:Pb,displacementmap_vertex:Ib,emissivemap_fragment:Lb,emissivemap_pars_fragment:Nb,colorspace_fragment:Db,colorspace_pars_fragment:Ob,envmap_fragment:Ub,envmap_common_pars_fragment:Fb,envmap_pars_fragment:kb,envmap_pars_vertex:Bb,envmap_physical_pars_fragment:jb,envmap_vertex:zb,fog_vertex:Hb,fog_pars_vertex:Vb,fog_fragment:Gb,fog_pars_fragment:Wb,gradientmap_pars_fragment:Xb,lightmap_pars_fragment:qb,lights_lambert_fragment:$b,lights_lambert_pars_fragment:Yb,lights_pars_begin:Kb,lights_toon_fragment:Zb,lights_toon_pars_fragment:Jb,lights_phong_fragment:Qb,lights_phong_pars_fragment:eS,lights_physical_fragment:tS,lights_physical_pars_fragment:nS,lights_fragment_begin:iS,lights_fragment_maps:sS,lights_fragment_end:rS,lightprobes_pars_fragment:oS,logdepthbuf_fragment:aS,logdepthbuf_pars_fragment:lS,logdepthbuf_pars_vertex:cS,logdepthbuf_vertex:hS,map_fragment:uS,map_pars_fragment:dS,map_particle_fragment:fS,map_particle_pars_fragment:pS,metalnessmap_fragment:mS,metalnessmap_pars_fragment:gS,morphinstance_vertex:xS,morphcolor_vertex:_S,morphnormal_vertex:vS,morphtarget_pars_vertex:yS,morphtarget_vertex:bS,normal_fragment_begin:SS,normal_fragment_maps:MS,normal_pars_fragment:wS,normal_pars_vertex:TS,normal_vertex:ES,normalmap_pars_fragment:AS,clearcoat_normal_fragment_begin:RS,clearcoat_normal_fragment_maps:CS,clearcoat_pars_fragment:PS,iridescence_pars_fragment:IS,opaque_fragment:LS,packing:NS,premultiplied_alpha_fragment:DS,project_vertex:OS,dithering_fragment:US,dithering_pars_fragment:FS,roughnessmap_fragment:kS,roughnessmap_pars_fragment:BS,shadowmap_pars_fragment:zS,shadowmap_pars_vertex:HS,shadowmap_vertex:VS,shadowmask_pars_fragment:GS,skinbase_vertex:WS,skinning_pars_vertex:XS,skinning_vertex:qS,skinnormal_vertex:$S,specularmap_fragment:YS,specularmap_pars_fragment:KS,tonemapping_fragment:jS,tonemapping_pars_fragment:ZS,transmission_fragment:JS,transmission_pars_fragment:QS,uv_pars_fragment:eM,uv_pars_vertex:tM,uv_vertex:nM,worldpos_vertex:iM,background_vert:sM,background_frag:rM,backgroundCube_vert:oM,backgroundCube_frag:aM,cube_vert:lM,cube_frag:cM,depth_vert:hM,depth_frag:uM,distance_vert:dM,distance_frag:fM,equirect_vert:pM,equirect_frag:mM,linedashed_vert:gM,linedashed_frag:xM,meshbasic_vert:_M,meshbasic_frag:vM,meshlambert_vert:yM,meshlambert_frag:bM,meshmatcap_vert:SM,meshmatcap_frag:MM,meshnormal_vert:wM,meshnormal_frag:TM,meshphong_vert:EM,meshphong_frag:AM,meshphysical_vert:RM,meshphysical_frag:CM,meshtoon_vert:PM,meshtoon_frag:IM,points_vert:LM,points_frag:NM,shadow_vert:DM,shadow_frag:OM,sprite_vert:UM,sprite_frag:FM},De={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},bs={basic:{uniforms:$n([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:$n([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:$n([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:$n([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:$n([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new je(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:$n([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:$n([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:$n([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:$n([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:$n([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:$n([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:$n([De.common,De.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:$n([De.lights,De.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};bs.physical={uniforms:$n([bs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Hh={r:0,b:0,g:0},kM=new ct,j0=new st;j0.set(-1,0,0,0,1,0,0,0,1);function BM(i,e,t,n,s,r){let o=new je(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=e.get(M,b)}return M}function p(y){let M=!1,b=f(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,M){let b=f(M);b&&b.isCubeTexture?(l===void 0&&(l=new ln(new Go(1,1,1),new ps({name:"BackgroundCubeMaterial",uniforms:$r(bs.backgroundCube.uniforms),vertexShader:bs.backgroundCube.vertexShader,fragmentShader:bs.backgroundCube.fragmentShader,side:si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(kM.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(j0),l.material.toneMapped=mt.getTransfer(b.colorSpace)!==Ct,(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new ln(new nl(2,2),new ps({name:"BackgroundMaterial",uniforms:$r(bs.background.uniforms),vertexShader:bs.background.vertexShader,fragmentShader:bs.background.fragmentShader,side:xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=mt.getTransfer(b.colorSpace)!==Ct,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function g(y,M){y.getRGB(Hh,Rf(i)),t.buffers.color.setClear(Hh.r,Hh.g,Hh.b,M,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:v,dispose:m}}function zM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,G,W,O,H){let Y=!1,B=u(L,O,W,G);r!==B&&(r=B,l(r.object)),Y=f(L,O,W,H),Y&&p(L,O,W,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(L,G,W,O),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,G,W,O){let H=O.wireframe===!0,Y=n[G.id];Y===void 0&&(Y={},n[G.id]=Y);let B=L.isInstancedMesh===!0?L.id:0,ce=Y[B];ce===void 0&&(ce={},Y[B]=ce);let Z=ce[W.id];Z===void 0&&(Z={},ce[W.id]=Z);let ee=Z[H];return ee===void 0&&(ee=d(c()),Z[H]=ee),ee}function d(L){let G=[],W=[],O=[];for(let H=0;H<t;H++)G[H]=0,W[H]=0,O[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:O,object:L,attributes:{},index:null}}function f(L,G,W,O){let H=r.attributes,Y=G.attributes,B=0,ce=W.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let se=H[Z],fe=Y[Z];if(fe===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;B++}return r.attributesNum!==B||r.index!==O}function p(L,G,W,O){let H={},Y=G.attributes,B=0,ce=W.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let se=Y[Z];se===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[Z]=fe,B++}r.attributes=H,r.attributesNum=B,r.index=O}function v(){let L=r.newAttributes;for(let G=0,W=L.length;G<W;G++)L[G]=0}function g(L){m(L,0)}function m(L,G){let W=r.newAttributes,O=r.enabledAttributes,H=r.attributeDivisors;W[L]=1,O[L]===0&&(i.enableVertexAttribArray(L),O[L]=1),H[L]!==G&&(i.vertexAttribDivisor(L,G),H[L]=G)}function y(){let L=r.newAttributes,G=r.enabledAttributes;for(let W=0,O=G.length;W<O;W++)G[W]!==L[W]&&(i.disableVertexAttribArray(W),G[W]=0)}function M(L,G,W,O,H,Y,B){B===!0?i.vertexAttribIPointer(L,G,W,H,Y):i.vertexAttribPointer(L,G,W,O,H,Y)}function b(L,G,W,O){v();let H=O.attributes,Y=W.getAttributes(),B=G.defaultAttributeValues;for(let ce in Y){let Z=Y[ce];if(Z.location>=0){let ee=H[ce];if(ee===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor)),ee!==void 0){let se=ee.normalized,fe=ee.itemSize,de=e.get(ee);if(de===void 0)continue;let te=de.buffer,ge=de.type,ve=de.bytesPerElement,Re=ge===i.INT||ge===i.UNSIGNED_INT||ee.gpuType===nh;if(ee.isInterleavedBufferAttribute){let Me=ee.data,$e=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,at=ee.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let We=0;We<Z.locationSize;We++)m(Z.location+We,Me.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let We=0;We<Z.locationSize;We++)g(Z.location+We);i.bindBuffer(i.ARRAY_BUFFER,te);for(let We=0;We<Z.locationSize;We++)M(Z.location+We,fe/Z.locationSize,ge,se,$e*ve,(at+fe/Z.locationSize*We)*ve,Re)}else{if(ee.isInstancedBufferAttribute){for(let Me=0;Me<Z.locationSize;Me++)m(Z.location+Me,ee.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let Me=0;Me<Z.locationSize;Me++)g(Z.location+Me);i.bindBuffer(i.ARRAY_BUFFER,te);for(let Me=0;Me<Z.locationSize;Me++)M(Z.location+Me,fe/Z.locationSize,ge,se,fe*ve,fe/Z.locationSize*Me*ve,Re)}}else if(B!==void 0){let se=B[ce];if(se!==void 0)switch(se.length){case 2:i.vertexAttrib2fv(Z.location,se);break;case 3:i.vertexAttrib3fv(Z.location,se);break;case 4:i.vertexAttrib4fv(Z.location,se);break;default:i.vertexAttrib1fv(Z.location,se)}}}}y()}function R(){k();for(let L in n){let G=n[L];for(let W in G){let O=G[W];for(let H in O){let Y=O[H];for(let B in Y)h(Y[B].object),delete Y[B];delete O[H]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let G=n[L.id];for(let W in G){let O=G[W];for(let H in O){let Y=O[H];for(let B in Y)h(Y[B].object),delete Y[B];delete O[H]}}delete n[L.id]}function x(L){for(let G in n){let W=n[G];for(let O in W){let H=W[O];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let B in Y)h(Y[B].object),delete Y[B];delete H[L.id]}}}function E(L){for(let G in n){let W=n[G],O=L.isInstancedMesh===!0?L.id:0,H=W[O];if(H!==void 0){for(let Y in H){let B=H[Y];for(let ce in B)h(B[ce].object),delete B[ce];delete H[Y]}delete W[O],Object.keys(W).length===0&&delete n[G]}}}function k(){D(),o=!0,r!==s&&(r=s,l(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function HM(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),t.update(l,n,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function VM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ui&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ci&&x!==yi&&!E&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(qe("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:R,samples:A}}function GM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Bn,a=new st,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,v=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):l();else{let y=r?0:n,M=y*4,b=m.clippingState||null;c.value=b,b=h(p,d,M,f);for(let R=0;R!==M;++R)b[R]=t[R];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let v=u!==null?u.length:0,g=null;if(v!==0){if(g=c.value,p!==!0||g===null){let m=f+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,b=f;M!==v;++M,b+=4)o.copy(u[M]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var wl=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Qa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Go(5,5,5),r=new ps({name:"CubemapFromEquirect",uniforms:$r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:si,blending:Vr});r.uniforms.tEquirect.value=t;let o=new ln(s,r),a=t.minFilter;return t.minFilter===Oi&&(t.minFilter=bn),new qo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},R0=256,WM=3,XM=20,Z0=256,J0=16,qM=3,$M=new X,YM=new je,Gh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qo(1,10,null),this._boxMesh=new ln(new Go(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=$M}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,v=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,v===null&&(e.background=c.getClearColor(YM));let g=new qo(n,s,h);return g.position.copy(a),g.update(c,e),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=I0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=P0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(R0,Tf(e))}_fromTexture(e,t){e.mapping===Wr||e.mapping===jo?this._setSize(e.image.length===0?R0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=C0(e,!1,!1),n=Math.log2(e)-WM;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=C0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Wr||e.mapping===jo?(this._cubemapMaterial===null&&(this._cubemapMaterial=I0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=P0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=KM(),this._integrationMaterial=jM());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/J0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-qM)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(Z0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ZM());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function C0(i,e,t){return new wl(i,{minFilter:Oi,generateMipmaps:e,type:Zi,colorSpace:ti,depthBuffer:t})}function Tl(i,e,t){return new ps({name:i,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:si,blending:Vr,depthTest:!1,depthWrite:!1})}function KM(){return Tl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Z0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function jM(){return Tl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:J0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ZM(){return Tl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${XM}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function P0(){return Tl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function I0(){return Tl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function JM(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Qc||f===eh)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let v=new wl(p.height);return v.fromEquirectangularTexture(i,d),e.set(d,v),d.addEventListener("dispose",l),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Qc||f===eh,v=f===Wr||f===jo;if(p||v){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Gh(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let y=d.image;return p&&y&&y.height>0||v&&y&&c(y)?(n===null&&(n=new Gh(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===Qc?d.mapping=Wr:f===eh&&(d.mapping=jo),d}function c(d){let f=0,p=6;for(let v=0;v<p;v++)d[v]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function QM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Nr("WebGLRenderer: "+n+" extension not supported."),s}}}function ew(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function l(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function u(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,M=g.count>=65535?qa:Xa,b=new M(Math.ceil(y/3)*6,1),R=b.array;if(v!==null){let x=v.array;m=v.version;for(let E=0,k=0;E<y;E+=3){let D=x[E+0],L=x[E+1],G=x[E+2];R[k++]=D,R[k++]=L,R[k++]=L,R[k++]=G,R[k++]=G,R[k++]=D}}else{m=g.version;for(let x=0,E=0;x<y;x+=3){let k=x+0,D=x+1,L=x+2;R[E++]=k,R[E++]=D,R[E++]=D,R[E++]=L,R[E++]=L,R[E++]=k}}b.version=m;let A=r.get(p);A&&e.remove(A),r.set(p,b)}function d(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&c(v)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function tw(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function l(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let g=0;g<f;g++)v+=d[g];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function nw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function iw(i,e,t){let n=new WeakMap,s=new Dt;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let k=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,R=1;b>e.maxTextureSize&&(R=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let A=new Float32Array(b*R*4*u),x=new Ga(A,b,R,u);x.type=yi,x.needsUpdate=!0;let E=M*4;for(let D=0;D<u;D++){let L=g[D],G=m[D],W=y[D],O=b*R*4*D;for(let H=0;H<L.count;H++){let Y=H*E;f===!0&&(s.fromBufferAttribute(L,H),A[O+Y+0]=s.x,A[O+Y+1]=s.y,A[O+Y+2]=s.z,A[O+Y+3]=0),p===!0&&(s.fromBufferAttribute(G,H),A[O+Y+4]=s.x,A[O+Y+5]=s.y,A[O+Y+6]=s.z,A[O+Y+7]=0),v===!0&&(s.fromBufferAttribute(W,H),A[O+Y+8]=s.x,A[O+Y+9]=s.y,A[O+Y+10]=s.z,A[O+Y+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new Ke(b,R)},n.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<l.length;v++)f+=l[v];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function sw(i,e,t,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=e.get(l,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var rw={[sf]:"LINEAR_TONE_MAPPING",[rf]:"REINHARD_TONE_MAPPING",[of]:"CINEON_TONE_MAPPING",[af]:"ACES_FILMIC_TONE_MAPPING",[cf]:"AGX_TONE_MAPPING",[hf]:"NEUTRAL_TONE_MAPPING",[lf]:"CUSTOM_TONE_MAPPING"};function ow(i,e,t,n,s,r){let o=new vi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new ni;h.setAttribute("position",new Dn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Dn([0,2,0,0,2,0],2));let u=new Vc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new ln(h,u),f=new Br(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,y=null,M=[],b=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),c!==null&&c.setSize(R,A);for(let x=0;x<M.length;x++){let E=M[x];E.setSize&&E.setSize(R,A)}},this.setEffects=function(R){M=R,b=M.length>0&&M[0].isRenderPass===!0;let A=o.width,x=o.height;M.length>0&&a===null&&(a=new vi(A,x,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),c=new vi(A,x,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new zs(A,x),r===!0&&(l.format=qs,l.type=qr)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<M.length;k++){let D=M[k];D.setSize&&D.setSize(A,x),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(R,A){if(g||R.toneMapping===_s&&M.length===0)return!1;if(y=A,A!==null){let x=A.width,E=A.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return b===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=_s,!0},this.hasRenderPass=function(){return b},this.end=function(R,A){R.toneMapping=m,g=!0;let x=o,E=a;for(let k=0;k<M.length;k++){let D=M[k];D.enabled!==!1&&(D.render(R,E,x,A),D.needsSwap!==!1&&(x=E,E=E===a?c:a))}if(p!==R.outputColorSpace||v!==R.toneMapping){p=R.outputColorSpace,v=R.toneMapping,u.defines={},mt.getTransfer(p)===Ct&&(u.defines.SRGB_TRANSFER="");let k=rw[v];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(y),R.render(d,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var Q0=new Un,ex=new zs(1,1),tx=new el(1),nx=new Ga,ix=new kc,sx=new Qa,L0=[],N0=[],D0=new Float32Array(16),O0=new Float32Array(9),U0=new Float32Array(4);function na(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=L0[s];if(r===void 0&&(r=new Float32Array(s),L0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Sn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Xh(i,e){let t=N0[e];t===void 0&&(t=new Int32Array(e),N0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function aw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function lw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2fv(this.addr,e),Mn(t,e)}}function cw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;i.uniform3fv(this.addr,e),Mn(t,e)}}function hw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4fv(this.addr,e),Mn(t,e)}}function uw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;U0.set(n),i.uniformMatrix2fv(this.addr,!1,U0),Mn(t,n)}}function dw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;O0.set(n),i.uniformMatrix3fv(this.addr,!1,O0),Mn(t,n)}}function fw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;D0.set(n),i.uniformMatrix4fv(this.addr,!1,D0),Mn(t,n)}}function pw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2iv(this.addr,e),Mn(t,e)}}function gw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3iv(this.addr,e),Mn(t,e)}}function xw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4iv(this.addr,e),Mn(t,e)}}function _w(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2uiv(this.addr,e),Mn(t,e)}}function yw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3uiv(this.addr,e),Mn(t,e)}}function bw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4uiv(this.addr,e),Mn(t,e)}}function qh(i){return i.version===0&&(i.compareFunction=bf,i.needsUpdate=!0),i}function Sw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=qh(ex):r=Q0,t.setTexture2D(e||r,s)}function Mw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||ix,s)}function ww(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=qh(tx):r=sx,t.setTextureCube(e||r,s)}function Tw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||nx,s)}function Ew(i){switch(i){case 5126:return aw;case 35664:return lw;case 35665:return cw;case 35666:return hw;case 35674:return uw;case 35675:return dw;case 35676:return fw;case 5124:case 35670:return pw;case 35667:case 35671:return mw;case 35668:case 35672:return gw;case 35669:case 35673:return xw;case 5125:return _w;case 36294:return vw;case 36295:return yw;case 36296:return bw;case 35678:case 36198:case 36298:case 36306:case 35682:return Sw;case 35679:case 36299:case 36307:return Mw;case 35680:case 36300:case 36308:case 36293:return ww;case 36289:case 36303:case 36311:case 36292:return Tw}}function Aw(i,e){i.uniform1fv(this.addr,e)}function Rw(i,e){let t=na(e,this.size,2);i.uniform2fv(this.addr,t)}function Cw(i,e){let t=na(e,this.size,3);i.uniform3fv(this.addr,t)}function Pw(i,e){let t=na(e,this.size,4);i.uniform4fv(this.addr,t)}function Iw(i,e){let t=na(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Lw(i,e){let t=na(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Nw(i,e){let t=na(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Dw(i,e){i.uniform1iv(this.addr,e)}function Ow(i,e){i.uniform2iv(this.addr,e)}function Uw(i,e){i.uniform3iv(this.addr,e)}function Fw(i,e){i.uniform4iv(this.addr,e)}function kw(i,e){i.uniform1uiv(this.addr,e)}function Bw(i,e){i.uniform2uiv(this.addr,e)}function zw(i,e){i.uniform3uiv(this.addr,e)}function Hw(i,e){i.uniform4uiv(this.addr,e)}function Vw(i,e,t){let n=this.cache,s=e.length,r=Xh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=qh(ex):o=Q0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Gw(i,e,t){let n=this.cache,s=e.length,r=Xh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ix,r[o])}function Ww(i,e,t){let n=this.cache,s=e.length,r=Xh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=qh(tx):o=sx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Xw(i,e,t){let n=this.cache,s=e.length,r=Xh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||nx,r[o])}function qw(i){switch(i){case 5126:return Aw;case 35664:return Rw;case 35665:return Cw;case 35666:return Pw;case 35674:return Iw;case 35675:return Lw;case 35676:return Nw;case 5124:case 35670:return Dw;case 35667:case 35671:return Ow;case 35668:case 35672:return Uw;case 35669:case 35673:return Fw;case 5125:return kw;case 36294:return Bw;case 36295:return zw;case 36296:return Hw;case 35678:case 36198:case 36298:case 36306:case 35682:return Vw;case 35679:case 36299:case 36307:return Gw;case 35680:case 36300:case 36308:case 36293:return Ww;case 36289:case 36303:case 36311:case 36292:return Xw}}var Df=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Ew(t.type)}},Of=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=qw(t.type)}},Uf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Lf=/(\w+)(\])?(\[|\.)?/g;function F0(i,e){i.seq.push(e),i.map[e.id]=e}function $w(i,e,t){let n=i.name,s=n.length;for(Lf.lastIndex=0;;){let r=Lf.exec(n),o=Lf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){F0(t,l===void 0?new Df(a,i,e):new Of(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Uf(a),F0(t,u)),t=u}}}var ta=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);$w(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function k0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Yw=37297,Kw=0;function jw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var B0=new st;function Zw(i){mt._getMatrix(B0,mt.workingColorSpace,i);let e=`mat3( ${B0.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(i)){case Ha:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function z0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+jw(i.getShaderSource(e),a)}else return r}function Jw(i,e){let t=Zw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Qw={[sf]:"Linear",[rf]:"Reinhard",[of]:"Cineon",[af]:"ACESFilmic",[cf]:"AgX",[hf]:"Neutral",[lf]:"Custom"};function eT(i,e){let t=Qw[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Vh=new X;function tT(){mt.getLuminanceCoefficients(Vh);let i=Vh.x.toFixed(4),e=Vh.y.toFixed(4),t=Vh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function nT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ml).join(`
`)}function iT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function sT(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ml(i){return i!==""}function H0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function V0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var rT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ff(i){return i.replace(rT,oT)}function oT(i,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ff(t)}var aT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function G0(i){return i.replace(aT,lT)}function lT(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function W0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var cT={[pl]:"SHADOWMAP_TYPE_PCF",[Yo]:"SHADOWMAP_TYPE_VSM"};function hT(i){return cT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var uT={[jo]:"ENVMAP_MODE_REFRACTION"};function dT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":uT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var fT={[nf]:"ENVMAP_BLENDING_MULTIPLY",[l0]:"ENVMAP_BLENDING_MIX",[c0]:"ENVMAP_BLENDING_ADD"};function pT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":fT[i.combine]||"ENVMAP_BLENDING_NONE"}function mT(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=hT(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=dT(t),u=pT(t),d=nT(t),f=iT(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ml).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ml).join(`
`),g.length>0&&(g+=`
`)):(v=[W0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ml).join(`
`),g=[W0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?ft.tonemapping_pars_fragment:"",t.toneMapping!==_s?eT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,Jw("linearToOutputTexel",t.outputColorSpace),tT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ml).join(`
`)),o=Ff(o),o=H0(o,t),o=V0(o,t),a=Ff(a),a=H0(a,t),a=V0(a,t),o=G0(o),a=G0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Mf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Mf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+v+o,M=m+g+a,b=k0(s,s.VERTEX_SHADER,y),R=k0(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,R),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(D){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(R)||"",O=L.trim(),H=G.trim(),Y=W.trim(),B=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,R);else{let Z=z0(s,b,"vertex"),ee=z0(s,R,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+O+`
`+Z+`
`+ee)}else O!==""?qe("WebGLProgram: Program Info Log:",O):(H===""||Y==="")&&(ce=!1);ce&&(D.diagnostics={runnable:B,programLog:O,vertexShader:{log:H,prefix:v},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(R),x=new ta(s,p),E=sT(s,p)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,Yw)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Kw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=R,this}var gT=0,kf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Bf(e),t.set(e,n)),n}},Bf=class{constructor(e){this.id=gT++,this.code=e,this.usedTimes=0}};function xT(i){return i===gr||i===vl||i===yl}function _T(i,e,t,n,s,r){let o=new Oo,a=new kf,c=new Set,l=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return c.add(x),x===0?"uv":`uv${x}`}function p(x,E,k,D,L,G){let W=D.fog,O=L.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,B=e.get(x.envMap||H,Y),ce=d[x.type],Z=n.precision;x.precision!==null&&(Z=n.getMaxPrecision(x.precision),Z!==x.precision&&qe("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let ee=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,se=ee!==void 0?ee.length:0,fe=0;O.morphAttributes.position!==void 0&&(fe=1),O.morphAttributes.normal!==void 0&&(fe=2),O.morphAttributes.color!==void 0&&(fe=3);let de,te,ge,ve;if(ce){let Ce=bs[ce];de=Ce.vertexShader,te=Ce.fragmentShader}else{de=x.vertexShader,te=x.fragmentShader;let Ce=a.getVertexShaderStage(x),ht=a.getFragmentShaderStage(x);a.update(x,Ce,ht),ge=Ce.id,ve=ht.id}let Re=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),$e=L.isInstancedMesh===!0,at=L.isBatchedMesh===!0,We=!!x.map,pt=!!x.matcap,ut=!!B,rt=ut&&B.isPMREMTexture===!0,Yt=!!x.aoMap,Ht=!!x.lightMap,cn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,Rn=!!x.displacementMap,Mt=!!x.emissiveMap,xn=!!x.metalnessMap,Qt=!!x.roughnessMap,hn=x.anisotropy>0,F=x.clearcoat>0,Pe=x.diffuseRoughness>0,Je=x.dispersion>0,lt=x.retroreflectivity>0,we=x.iridescence>0,Ft=x.sheen>0,Ge=x.transmission>0,Ze=hn&&!!x.anisotropyMap,C=F&&!!x.clearcoatMap,S=F&&!!x.clearcoatNormalMap,q=F&&!!x.clearcoatRoughnessMap,ue=Pe&&!!x.diffuseRoughnessMap,ae=we&&!!x.iridescenceMap,_e=we&&!!x.iridescenceThicknessMap,ye=Ft&&!!x.sheenColorMap,ne=Ft&&!!x.sheenRoughnessMap,re=!!x.specularMap,me=!!x.specularColorMap,U=!!x.specularIntensityMap,oe=Ge&&!!x.transmissionMap,ie=Ge&&!!x.thicknessMap,Te=!!x.gradientMap,xe=!!x.alphaMap,Se=x.alphaTest>0,Xe=!!x.alphaHash,et=!!x.extensions,he=_s;x.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(he=i.toneMapping);let ze=rt?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,tt={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:de,fragmentShader:te,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:at,batchingColor:at&&L._colorsTexture!==null,instancing:$e,instancingColor:$e&&L.instanceColor!==null,instancingMorph:$e&&L.morphTexture!==null,outputColorSpace:Re===null?i.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:We,matcap:pt,envMap:ut,envMapMode:ut&&B.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:Yt,lightMap:Ht,bumpMap:cn,normalMap:Ot,displacementMap:Rn,emissiveMap:Mt,normalMapObjectSpace:Ot&&x.normalMapType===f0,normalMapTangentSpace:Ot&&x.normalMapType===Bh,packedNormalMap:Ot&&x.normalMapType===Bh&&xT(x.normalMap.format),metalnessMap:xn,roughnessMap:Qt,anisotropy:hn,anisotropyMap:Ze,clearcoat:F,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Je,retroreflection:lt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:Ft,sheenColorMap:ye,sheenRoughnessMap:ne,specularMap:re,specularColorMap:me,specularIntensityMap:U,transmission:Ge,transmissionMap:oe,thicknessMap:ie,gradientMap:Te,opaque:x.transparent===!1&&x.blending===Ko&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Xe,combine:x.combine,mapUv:We&&f(x.map.channel),aoMapUv:Yt&&f(x.aoMap.channel),lightMapUv:Ht&&f(x.lightMap.channel),bumpMapUv:cn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:Rn&&f(x.displacementMap.channel),emissiveMapUv:Mt&&f(x.emissiveMap.channel),metalnessMapUv:xn&&f(x.metalnessMap.channel),roughnessMapUv:Qt&&f(x.roughnessMap.channel),anisotropyMapUv:Ze&&f(x.anisotropyMap.channel),clearcoatMapUv:C&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(x.sheenRoughnessMap.channel),specularMapUv:re&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:U&&f(x.specularIntensityMap.channel),transmissionMapUv:oe&&f(x.transmissionMap.channel),thicknessMapUv:ie&&f(x.thicknessMap.channel),alphaMapUv:xe&&f(x.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(Ot||hn),vertexNormals:!!O.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!O.attributes.uv&&(We||xe),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||O.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Me,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:We&&x.map.isVideoTexture===!0&&mt.getTransfer(x.map.colorSpace)===Ct,decodeVideoTextureEmissive:Mt&&x.emissiveMap.isVideoTexture===!0&&mt.getTransfer(x.emissiveMap.colorSpace)===Ct,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Di,flipSided:x.side===si,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=c.has(1),tt.vertexUv2s=c.has(2),tt.vertexUv3s=c.has(3),c.clear(),tt}function v(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)E.push(k),E.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(g(E,x),m(E,x),E.push(i.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function g(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function m(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let E=d[x.type],k;if(E){let D=bs[E];k=T0.clone(D.uniforms)}else k=x.uniforms;return k}function M(x,E){let k=h.get(E);return k!==void 0?++k.usedTimes:(k=new mT(i,E,x,s),l.push(k),h.set(E,k)),k}function b(x){if(--x.usedTimes===0){let E=l.indexOf(x);l[E]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:R,programs:l,dispose:A}}function vT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function yT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function X0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function q0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,v,g,m){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:g,group:m},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=g,y.group=m),e++,y}function c(d,f,p,v,g,m,y){y.reversedDepth===!0&&(g=-g);let M=a(d,f,p,v,g,m);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):t.push(M)}function l(d,f,p,v,g,m){let y=a(d,f,p,v,g,m);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||yT),n.length>1&&n.sort(f||X0),s.length>1&&s.sort(f||X0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function bT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new q0,i.set(n,[o])):s>=r.length?(o=new q0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function ST(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new je};break;case"SpotLight":t={position:new X,direction:new X,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new X,halfWidth:new X,halfHeight:new X};break}return i[e.id]=t,t}}}function MT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var wT=0;function TT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function ET(i){let e=new ST,t=MT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new X);let s=new X,r=new ct,o=new ct;function a(l){let h=0,u=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,y=0,M=0,b=0,R=0,A=0,x=0,E=0,k=0,D=0;l.sort(TT);for(let G=0,W=l.length;G<W;G++){let O=l[G],H=O.color,Y=O.intensity,B=O.distance,ce=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===gr?ce=O.shadow.map.texture:ce=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)h+=H.r*Y,u+=H.g*Y,d+=H.b*Y;else if(O.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(O.sh.coefficients[Z],Y);D++}else if(O.isSunLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[p]=se,n.sunShadowMap[p]=ce;let fe=ee.getViewportCount();for(let de=0;de<fe;de++)n.sunShadowMatrix[v+de]=ee.getMatrix(de),n.sunShadowCascade[v+de]=ee._cascadeData[de];v+=fe,p++}n.sun[f]=Z,f++}else if(O.isDirectionalLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,n.directionalShadow[g]=se,n.directionalShadowMap[g]=ce,n.directionalShadowMatrix[g]=O.shadow.matrix,R++}n.directional[g]=Z,g++}else if(O.isSpotLight){let Z=e.get(O);Z.position.setFromMatrixPosition(O.matrixWorld),Z.color.copy(H).multiplyScalar(Y),Z.distance=B,Z.coneCos=Math.cos(O.angle),Z.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),Z.decay=O.decay,n.spot[y]=Z;let ee=O.shadow;if(O.map&&(n.spotLightMap[E]=O.map,E++,ee.updateMatrices(O),O.castShadow&&k++),n.spotLightMatrix[y]=ee.matrix,O.castShadow){let se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,n.spotShadow[y]=se,n.spotShadowMap[y]=ce,x++}y++}else if(O.isRectAreaLight){let Z=e.get(O);Z.color.copy(H).multiplyScalar(Y),Z.halfWidth.set(O.width*.5,0,0),Z.halfHeight.set(0,O.height*.5,0),n.rectArea[M]=Z,M++}else if(O.isPointLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),Z.distance=O.distance,Z.decay=O.decay,O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,se.shadowCameraNear=ee.camera.near,se.shadowCameraFar=ee.camera.far,n.pointShadow[m]=se,n.pointShadowMap[m]=ce,n.pointShadowMatrix[m]=O.shadow.matrix,A++}n.point[m]=Z,m++}else if(O.isHemisphereLight){let Z=e.get(O);Z.skyColor.copy(O.color).multiplyScalar(Y),Z.groundColor.copy(O.groundColor).multiplyScalar(Y),n.hemi[b]=Z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=De.LTC_FLOAT_1,n.rectAreaLTC2=De.LTC_FLOAT_2):(n.rectAreaLTC1=De.LTC_HALF_1,n.rectAreaLTC2=De.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==y||L.rectAreaLength!==M||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==R||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==D)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=M,n.point.length=m,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+E-k,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=D,L.sunLength=f,L.directionalLength=g,L.pointLength=m,L.spotLength=y,L.rectAreaLength=M,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=R,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=D,n.version=wT++)}function c(l,h){let u=0,d=0,f=0,p=0,v=0,g=0,m=h.matrixWorldInverse;for(let y=0,M=l.length;y<M;y++){let b=l[y];if(b.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(b.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let R=n.rectArea[v];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:n}}function $0(i){let e=new ET(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function c(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function AT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new $0(i),e.set(s,[a])):r>=o.length?(a=new $0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var RT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,CT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,PT=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],IT=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Y0=new ct,Sl=new X,Nf=new X;function LT(i,e,t){let n=new ur,s=new Ke,r=new Ke,o=new Dt,a=new Gc,c=new Wc,l={},h=t.maxTextureSize,u={[xs]:si,[si]:xs,[Di]:Di},d=new ps({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:RT,fragmentShader:CT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new ni;p.setAttribute("position",new zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new ln(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=pl;let m=this.type;this.render=function(A,x,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Gg&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=pl);let k=i.getRenderTarget(),D=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Vr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=m!==this.type;W&&x.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach(H=>H.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,H=A.length;O<H;O++){let Y=A[O],B=Y.shadow;if(B===void 0){qe("WebGLShadowMap:",Y,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ce=B.getFrameExtents();s.multiply(ce),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,B.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Z,B.map===null||W===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Yo){if(Y.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new vi(s.x,s.y,{format:gr,type:Zi,minFilter:bn,magFilter:bn,generateMipmaps:!1}),B.map.texture.name=Y.name+".shadowMap",B.map.depthTexture=new zs(s.x,s.y,yi),B.map.depthTexture.name=Y.name+".shadowMapDepth",B.map.depthTexture.format=Fs,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=an,B.map.depthTexture.magFilter=an}else Y.isPointLight?(B.map=new wl(s.x),B.map.depthTexture=new el(s.x,ji)):(B.map=new vi(s.x,s.y),B.map.depthTexture=new zs(s.x,s.y,ji)),B.map.depthTexture.name=Y.name+".shadowMap",B.map.depthTexture.format=Fs,this.type===pl?(B.map.depthTexture.compareFunction=Z?yf:vf,B.map.depthTexture.minFilter=bn,B.map.depthTexture.magFilter=bn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=an,B.map.depthTexture.magFilter=an);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let ee=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();Y.isPointLight!==!0&&B.updateMatrices(Y,E);let se=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:E.layers;for(let fe=0;fe<ee;fe++){let de=B.getCamera(fe);if(Y.isPointLight){let te=B.camera,ge=B.matrix,ve=Y.distance||te.far;ve!==te.far&&(te.far=ve,te.updateProjectionMatrix()),Sl.setFromMatrixPosition(Y.matrixWorld),te.position.copy(Sl),Nf.copy(te.position),Nf.add(PT[fe]),te.up.copy(IT[fe]),te.lookAt(Nf),te.updateMatrixWorld(),ge.makeTranslation(-Sl.x,-Sl.y,-Sl.z),Y0.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),B._frustum.setFromProjectionMatrix(Y0,te.coordinateSystem,te.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,fe),i.clear();else{fe===0&&(i.setRenderTarget(B.map),i.clear());let te=B.getViewport(fe);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),G.viewport(o)}n=B.getFrustum(fe),b(x,E,de,Y,se,this.type)}B.isPointLightShadow!==!0&&this.type===Yo&&y(B,E),B.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(k,D,L)};function y(A,x){let E=e.update(v);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new vi(s.x,s.y,{format:gr,type:Zi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(x,null,E,d,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(x,null,E,f,v,null)}function M(A,x,E,k){let D=null,L=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?c:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=D.uuid,W=x.uuid,O=l[G];O===void 0&&(O={},l[G]=O);let H=O[W];H===void 0&&(H=D.clone(),O[W]=H,x.addEventListener("dispose",R)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,k===Yo?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:u[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let G=i.properties.get(D);G.light=E}return D}function b(A,x,E,k,D,L){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===Yo)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let O=e.update(A),H=A.material;if(Array.isArray(H)){let Y=O.groups;for(let B=0,ce=Y.length;B<ce;B++){let Z=Y[B],ee=H[Z.materialIndex];if(ee&&ee.visible){let se=M(A,ee,k,L);A.onBeforeShadow(i,A,x,E,O,se,Z),i.renderBufferDirect(E,null,O,se,A,Z),A.onAfterShadow(i,A,x,E,O,se,Z)}}}else if(H.visible){let Y=M(A,H,k,L);A.onBeforeShadow(i,A,x,E,O,Y,null),i.renderBufferDirect(E,null,O,Y,A,null),A.onAfterShadow(i,A,x,E,O,Y,null)}}let W=A.children;for(let O=0,H=W.length;O<H;O++)b(W[O],x,E,k,D,L)}function R(A){A.target.removeEventListener("dispose",R);for(let E in l){let k=l[E],D=A.target.uuid;D in k&&(k[D].dispose(),delete k[D])}}}function NT(i,e){function t(){let U=!1,oe=new Dt,ie=null,Te=new Dt(0,0,0,0);return{setMask:function(xe){ie!==xe&&!U&&(i.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){U=xe},setClear:function(xe,Se,Xe,et,he){he===!0&&(xe*=et,Se*=et,Xe*=et),oe.set(xe,Se,Xe,et),Te.equals(oe)===!1&&(i.clearColor(xe,Se,Xe,et),Te.copy(oe))},reset:function(){U=!1,ie=null,Te.set(-1,0,0,0)}}}function n(){let U=!1,oe=!1,ie=null,Te=null,xe=null;return{setReversed:function(Se){if(oe!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Se;let et=xe;xe=null,this.setClear(et)}},getReversed:function(){return oe},setTest:function(Se){Se?Me(i.DEPTH_TEST):$e(i.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!U&&(i.depthMask(Se),ie=Se)},setFunc:function(Se){if(oe&&(Se=M0[Se]),Te!==Se){switch(Se){case Cc:i.depthFunc(i.NEVER);break;case Pc:i.depthFunc(i.ALWAYS);break;case Ic:i.depthFunc(i.LESS);break;case Co:i.depthFunc(i.LEQUAL);break;case Lc:i.depthFunc(i.EQUAL);break;case Nc:i.depthFunc(i.GEQUAL);break;case Dc:i.depthFunc(i.GREATER);break;case Oc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){U=Se},setClear:function(Se){xe!==Se&&(xe=Se,oe&&(Se=1-Se),i.clearDepth(Se))},reset:function(){U=!1,ie=null,Te=null,xe=null,oe=!1}}}function s(){let U=!1,oe=null,ie=null,Te=null,xe=null,Se=null,Xe=null,et=null,he=null;return{setTest:function(ze){U||(ze?Me(i.STENCIL_TEST):$e(i.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!U&&(i.stencilMask(ze),oe=ze)},setFunc:function(ze,tt,Ce){(ie!==ze||Te!==tt||xe!==Ce)&&(i.stencilFunc(ze,tt,Ce),ie=ze,Te=tt,xe=Ce)},setOp:function(ze,tt,Ce){(Se!==ze||Xe!==tt||et!==Ce)&&(i.stencilOp(ze,tt,Ce),Se=ze,Xe=tt,et=Ce)},setLocked:function(ze){U=ze},setClear:function(ze){he!==ze&&(i.clearStencil(ze),he=ze)},reset:function(){U=!1,oe=null,ie=null,Te=null,xe=null,Se=null,Xe=null,et=null,he=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,R=null,A=null,x=null,E=new je(0,0,0),k=0,D=!1,L=null,G=null,W=null,O=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ce=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Z)[1]),B=ce>=1):Z.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),B=ce>=2);let ee=null,se={},fe=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),te=new Dt().fromArray(fe),ge=new Dt().fromArray(de);function ve(U,oe,ie,Te){let xe=new Uint8Array(4),Se=i.createTexture();i.bindTexture(U,Se),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<ie;Xe++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(oe+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Se}let Re={};Re[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Re[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Re[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),o.setFunc(Co),cn(!1),Ot(jd),Me(i.CULL_FACE),Yt(Vr);function Me(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function $e(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function at(U,oe){return d[U]!==oe?(i.bindFramebuffer(U,oe),d[U]=oe,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=oe),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(U,oe){let ie=p,Te=!1;if(U){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let xe=U.textures;if(ie.length!==xe.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Xe=xe.length;Se<Xe;Se++)ie[Se]=i.COLOR_ATTACHMENT0+Se;ie.length=xe.length,Te=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ie)}function pt(U){return v!==U?(i.useProgram(U),v=U,!0):!1}let ut={[Gr]:i.FUNC_ADD,[Xg]:i.FUNC_SUBTRACT,[qg]:i.FUNC_REVERSE_SUBTRACT};ut[$g]=i.MIN,ut[Yg]=i.MAX;let rt={[Kg]:i.ZERO,[jg]:i.ONE,[Zg]:i.SRC_COLOR,[ef]:i.SRC_ALPHA,[i0]:i.SRC_ALPHA_SATURATE,[t0]:i.DST_COLOR,[Qg]:i.DST_ALPHA,[Jg]:i.ONE_MINUS_SRC_COLOR,[tf]:i.ONE_MINUS_SRC_ALPHA,[n0]:i.ONE_MINUS_DST_COLOR,[e0]:i.ONE_MINUS_DST_ALPHA,[s0]:i.CONSTANT_COLOR,[r0]:i.ONE_MINUS_CONSTANT_COLOR,[o0]:i.CONSTANT_ALPHA,[a0]:i.ONE_MINUS_CONSTANT_ALPHA};function Yt(U,oe,ie,Te,xe,Se,Xe,et,he,ze){if(U===Vr){g===!0&&($e(i.BLEND),g=!1);return}if(g===!1&&(Me(i.BLEND),g=!0),U!==Wg){if(U!==m||ze!==D){if((y!==Gr||R!==Gr)&&(i.blendEquation(i.FUNC_ADD),y=Gr,R=Gr),ze)switch(U){case Ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Zd:i.blendFunc(i.ONE,i.ONE);break;case Jd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Qd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",U);break}else switch(U){case Ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Zd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Jd:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Qd:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",U);break}M=null,b=null,A=null,x=null,E.set(0,0,0),k=0,m=U,D=ze}return}xe=xe||oe,Se=Se||ie,Xe=Xe||Te,(oe!==y||xe!==R)&&(i.blendEquationSeparate(ut[oe],ut[xe]),y=oe,R=xe),(ie!==M||Te!==b||Se!==A||Xe!==x)&&(i.blendFuncSeparate(rt[ie],rt[Te],rt[Se],rt[Xe]),M=ie,b=Te,A=Se,x=Xe),(et.equals(E)===!1||he!==k)&&(i.blendColor(et.r,et.g,et.b,he),E.copy(et),k=he),m=U,D=!1}function Ht(U,oe){U.side===Di?$e(i.CULL_FACE):Me(i.CULL_FACE);let ie=U.side===si;oe&&(ie=!ie),cn(ie),U.blending===Ko&&U.transparent===!1?Yt(Vr):Yt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Te=U.stencilWrite;a.setTest(Te),Te&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),Mt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):$e(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(U){L!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),L=U)}function Ot(U){U!==Hg?(Me(i.CULL_FACE),U!==G&&(U===jd?i.cullFace(i.BACK):U===Vg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$e(i.CULL_FACE),G=U}function Rn(U){U!==W&&(B&&i.lineWidth(U),W=U)}function Mt(U,oe,ie){U?(Me(i.POLYGON_OFFSET_FILL),(O!==oe||H!==ie)&&(O=oe,H=ie,o.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):$e(i.POLYGON_OFFSET_FILL)}function xn(U){U?Me(i.SCISSOR_TEST):$e(i.SCISSOR_TEST)}function Qt(U){U===void 0&&(U=i.TEXTURE0+Y-1),ee!==U&&(i.activeTexture(U),ee=U)}function hn(U,oe,ie){ie===void 0&&(ee===null?ie=i.TEXTURE0+Y-1:ie=ee);let Te=se[ie];Te===void 0&&(Te={type:void 0,texture:void 0},se[ie]=Te),(Te.type!==U||Te.texture!==oe)&&(ee!==ie&&(i.activeTexture(ie),ee=ie),i.bindTexture(U,oe||Re[U]),Te.type=U,Te.texture=oe)}function F(){let U=se[ee];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Pe(){try{i.compressedTexImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function lt(){try{i.texSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ft(){try{i.compressedTexSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ge(){try{i.compressedTexSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ze(){try{i.texStorage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function C(){try{i.texStorage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function S(){try{i.texImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function q(){try{i.texImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function ue(U){return u[U]!==void 0?u[U]:i.getParameter(U)}function ae(U,oe){u[U]!==oe&&(i.pixelStorei(U,oe),u[U]=oe)}function _e(U){te.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),te.copy(U))}function ye(U){ge.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),ge.copy(U))}function ne(U,oe){let ie=l.get(oe);ie===void 0&&(ie=new WeakMap,l.set(oe,ie));let Te=ie.get(U);Te===void 0&&(Te=i.getUniformBlockIndex(oe,U.name),i.uniformBlockBinding(oe,Te,Te),ie.set(U,Te))}function re(U,oe,ie){let xe=l.get(oe).get(U);c[xe]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ie),c[xe]=ie)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ee=null,se={},d={},c={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,R=null,A=null,x=null,E=new je(0,0,0),k=0,D=!1,L=null,G=null,W=null,O=null,H=null,te.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:$e,bindFramebuffer:at,drawBuffers:We,useProgram:pt,setBlending:Yt,setMaterial:Ht,setFlipSided:cn,setCullFace:Ot,setLineWidth:Rn,setPolygonOffset:Mt,setScissorTest:xn,activeTexture:Qt,bindTexture:hn,unbindTexture:F,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:S,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:C,texSubImage2D:lt,texSubImage3D:we,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Ge,scissor:_e,viewport:ye,reset:me}}function DT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ke,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,v=new FinalizationRegistry(C=>p.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,S){return g?new OffscreenCanvas(C,S):Lo("canvas")}function y(C,S,q){let ue=1,ae=Ze(C);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ye=Math.floor(ue*ae.height);d===void 0&&(d=m(_e,ye));let ne=S?m(_e,ye):d;return ne.width=_e,ne.height=ye,ne.getContext("2d").drawImage(C,0,0,_e,ye),qe("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),ne}else return"data"in C&&qe("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),C;return C}function M(C){return C.generateMipmaps}function b(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(C,S,q,ue,ae,_e=!1){if(C!==null){if(i[C]!==void 0)return i[C];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===i.RED&&(q===i.FLOAT&&(ne=i.R32F),q===i.HALF_FLOAT&&(ne=i.R16F),q===i.UNSIGNED_BYTE&&(ne=i.R8),q===i.UNSIGNED_SHORT&&ye&&(ne=ye.R16_EXT),q===i.SHORT&&ye&&(ne=ye.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.R8UI),q===i.UNSIGNED_SHORT&&(ne=i.R16UI),q===i.UNSIGNED_INT&&(ne=i.R32UI),q===i.BYTE&&(ne=i.R8I),q===i.SHORT&&(ne=i.R16I),q===i.INT&&(ne=i.R32I)),S===i.RG&&(q===i.FLOAT&&(ne=i.RG32F),q===i.HALF_FLOAT&&(ne=i.RG16F),q===i.UNSIGNED_BYTE&&(ne=i.RG8),q===i.UNSIGNED_SHORT&&ye&&(ne=ye.RG16_EXT),q===i.SHORT&&ye&&(ne=ye.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RG8UI),q===i.UNSIGNED_SHORT&&(ne=i.RG16UI),q===i.UNSIGNED_INT&&(ne=i.RG32UI),q===i.BYTE&&(ne=i.RG8I),q===i.SHORT&&(ne=i.RG16I),q===i.INT&&(ne=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),q===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),q===i.UNSIGNED_INT&&(ne=i.RGB32UI),q===i.BYTE&&(ne=i.RGB8I),q===i.SHORT&&(ne=i.RGB16I),q===i.INT&&(ne=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),q===i.UNSIGNED_INT&&(ne=i.RGBA32UI),q===i.BYTE&&(ne=i.RGBA8I),q===i.SHORT&&(ne=i.RGBA16I),q===i.INT&&(ne=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGB16_EXT),q===i.SHORT&&ye&&(ne=ye.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),S===i.RGBA){let re=_e?Ha:mt.getTransfer(ae);q===i.FLOAT&&(ne=i.RGBA32F),q===i.HALF_FLOAT&&(ne=i.RGBA16F),q===i.UNSIGNED_BYTE&&(ne=re===Ct?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGBA16_EXT),q===i.SHORT&&ye&&(ne=ye.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function x(C,S){let q;return C?S===null||S===ji||S===qr?q=i.DEPTH24_STENCIL8:S===yi?q=i.DEPTH32F_STENCIL8:S===Jo&&(q=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ji||S===qr?q=i.DEPTH_COMPONENT24:S===yi?q=i.DEPTH_COMPONENT32F:S===Jo&&(q=i.DEPTH_COMPONENT16),q}function E(C,S){return M(C)===!0||C.isFramebufferTexture&&C.minFilter!==an&&C.minFilter!==bn?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function k(C){let S=new WeakRef(C);n.get(C).__ref=S,p.add(S),v.register(C,S,S)}function D(C){let S=n.get(C).__ref;S!==void 0&&(p.delete(S),v.unregister(S))}function L(C){W(C.target)}function G(C){O(C.target)}function W(C){C.removeEventListener("dispose",L),D(C),Y(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function O(C){C.removeEventListener("dispose",G),D(C),ce(C)}function H(){for(let C of p){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?O(S):W(S))}p.clear(),u.clear()}function Y(C){let S=n.get(C);if(S.__webglInit===void 0)return;let q=C.source,ue=f.get(q);if(ue){let ae=ue[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&B(C),Object.keys(ue).length===0&&f.delete(q)}n.remove(C)}function B(C){let S=n.get(C);i.deleteTexture(S.__webglTexture);let q=C.source,ue=f.get(q);delete ue[S.__cacheKey],o.memory.textures--}function ce(C){let S=n.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&W(q),C.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let _e=0;_e<S.__webglFramebuffer[ae].length;_e++)i.deleteFramebuffer(S.__webglFramebuffer[ae][_e]);else i.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)i.deleteFramebuffer(S.__webglFramebuffer[ae]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=C.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ye=n.get(ue[ae]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(ue[ae])}n.remove(C)}let Z=0;function ee(){Z=0}function se(){return Z}function fe(C){Z=C}function de(){let C=Z;return C>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,C}function te(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function ge(C,S){let q=n.get(C);if(C.isVideoTexture&&Ft(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let ue=C.image;if(ue===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)qe("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function ve(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ht(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function Re(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ht(q,C,S);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function Me(C,S){let q=n.get(C);if(C.version>0&&q.__version!==C.version){cn(q,C,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let $e={[hr]:i.REPEAT,[Ii]:i.CLAMP_TO_EDGE,[Po]:i.MIRRORED_REPEAT},at={[an]:i.NEAREST,[th]:i.NEAREST_MIPMAP_NEAREST,[Xr]:i.NEAREST_MIPMAP_LINEAR,[bn]:i.LINEAR,[Zo]:i.LINEAR_MIPMAP_NEAREST,[Oi]:i.LINEAR_MIPMAP_LINEAR},We={[m0]:i.NEVER,[bf]:i.ALWAYS,[g0]:i.LESS,[vf]:i.LEQUAL,[x0]:i.EQUAL,[yf]:i.GEQUAL,[_0]:i.GREATER,[v0]:i.NOTEQUAL};function pt(C,S){if(S.type===yi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===bn||S.magFilter===Zo||S.magFilter===Xr||S.magFilter===Oi||S.minFilter===bn||S.minFilter===Zo||S.minFilter===Xr||S.minFilter===Oi)&&qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,$e[S.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,$e[S.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,$e[S.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,at[S.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,at[S.minFilter]),S.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,We[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===an||S.minFilter!==Xr&&S.minFilter!==Oi||S.type===yi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ut(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L),k(S));let ue=S.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let _e=te(S);if(_e!==C.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let ye=ae[C.__cacheKey];ye!==void 0&&(ae[C.__cacheKey].usedTimes--,ye.usedTimes===0&&B(S)),C.__cacheKey=_e,C.__webglTexture=ae[_e].texture}return q}function rt(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Yt(C,S,q,ue){let _e=C.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{_e.sort((U,oe)=>U.start-oe.start);let ye=0;for(let U=1;U<_e.length;U++){let oe=_e[ye],ie=_e[U],Te=oe.start+oe.count,xe=rt(ie.start,S.width,4),Se=rt(oe.start,S.width,4);ie.start<=Te+1&&xe===Se&&rt(ie.start+ie.count-1,S.width,4)===xe?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++ye,_e[ye]=ie)}_e.length=ye+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let U=0,oe=_e.length;U<oe;U++){let ie=_e[U],Te=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Se=Te%S.width,Xe=Math.floor(Te/S.width),et=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Se,Xe,et,he,q,ue,S.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Ht(C,S,q){let ue=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=i.TEXTURE_3D);let ae=ut(C,S),_e=S.source;t.bindTexture(ue,C.__webglTexture,i.TEXTURE0+q);let ye=n.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=mt.getPrimaries(mt.workingColorSpace),ze=S.colorSpace===$s?null:mt.getPrimaries(S.colorSpace),tt=S.colorSpace===$s||he===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let re=y(S.image,!1,s.maxTextureSize);re=Ge(S,re);let me=r.convert(S.format,S.colorSpace),U=r.convert(S.type),oe=A(S.internalFormat,me,U,S.normalized,S.colorSpace,S.isVideoTexture);pt(ue,S);let ie,Te=S.mipmaps,xe=S.isVideoTexture!==!0,Se=ye.__version===void 0||ae===!0,Xe=_e.dataReady,et=E(S,re);if(S.isDepthTexture)oe=x(S.format===qs,S.type),Se&&(xe?t.texStorage2D(i.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,null));else if(S.isDataTexture)if(Te.length>0){xe&&Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,me,U,ie.data);S.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,re.width,re.height),Xe&&Yt(S,re,me,U)):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,re.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,oe,Te[0].width,Te[0].height,re.depth);for(let he=0,ze=Te.length;he<ze;he++)if(ie=Te[he],S.format!==Ui)if(me!==null)if(xe){if(Xe)if(S.layerUpdates.size>0){let tt=If(ie.width,ie.height,S.format,S.type);for(let Ce of S.layerUpdates){let ht=ie.data.subarray(Ce*tt/ie.data.BYTES_PER_ELEMENT,(Ce+1)*tt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ce,ie.width,ie.height,1,me,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,re.depth,me,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,re.depth,0,ie.data,0,0);else qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,re.depth,me,U,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,re.depth,0,me,U,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],S.format!==Ui?me!==null?xe?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,ie.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,me,U,ie.data)}else if(S.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,oe,re.width,re.height,re.depth),Xe)if(S.layerUpdates.size>0){let he=If(re.width,re.height,S.format,S.type);for(let ze of S.layerUpdates){let tt=re.data.subarray(ze*he/re.data.BYTES_PER_ELEMENT,(ze+1)*he/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,me,U,tt)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isData3DTexture)xe?(Se&&t.texStorage3D(i.TEXTURE_3D,et,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)):t.texImage3D(i.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(i.TEXTURE_2D,et,oe,re.width,re.height);else{let he=re.width,ze=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,oe,he,ze,0,me,U,null),he>>=1,ze>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),re.parentNode!==he){he.appendChild(re),u.add(S),he.onpaint=ze=>{let tt=ze.changedElements;for(let Ce of u)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let tt=i.RGBA,Ce=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ce,ht,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Se){let he=Ze(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,oe,he.width,he.height)}for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,U,ie):t.texImage2D(i.TEXTURE_2D,he,oe,me,U,ie);S.generateMipmaps=!1}else if(xe){if(Se){let he=Ze(re);t.texStorage2D(i.TEXTURE_2D,et,oe,he.width,he.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,U,re)}else t.texImage2D(i.TEXTURE_2D,0,oe,me,U,re);M(S)&&S.mipmapsAutoUpdate===!0&&b(ue),ye.__version=_e.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function cn(C,S,q){if(S.image.length!==6)return;let ue=ut(C,S),ae=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+q);let _e=n.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(i.TEXTURE0+q);let ye=mt.getPrimaries(mt.workingColorSpace),ne=S.colorSpace===$s?null:mt.getPrimaries(S.colorSpace),re=S.colorSpace===$s||ye===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!me&&!U?oe[Ce]=y(S.image[Ce],!0,s.maxCubemapSize):oe[Ce]=U?S.image[Ce].image:S.image[Ce],oe[Ce]=Ge(S,oe[Ce]);let ie=oe[0],Te=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),Se=A(S.internalFormat,Te,xe,S.normalized,S.colorSpace),Xe=S.isVideoTexture!==!0,et=_e.__version===void 0||ue===!0,he=ae.dataReady,ze=E(S,ie);pt(i.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Se=x(S.format===qs,S.type),et)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ie.width,ie.height,0,Te,xe,null)}else if(me){Xe&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){tt=oe[Ce].mipmaps;for(let ht=0;ht<tt.length;ht++){let Gt=tt[ht];S.format!==Ui?Te!==null?Xe?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Gt.width,Gt.height,Te,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Gt.width,Gt.height,0,Gt.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Gt.width,Gt.height,Te,xe,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Gt.width,Gt.height,0,Te,xe,Gt.data)}}}else{if(tt=S.mipmaps,Xe&&et){tt.length>0&&ze++;let Ce=Ze(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(U){Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,Te,xe,oe[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,oe[Ce].width,oe[Ce].height,0,Te,xe,oe[Ce].data);for(let ht=0;ht<tt.length;ht++){let Kn=tt[ht].image[Ce].image;Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,Kn.width,Kn.height,Te,xe,Kn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,Kn.width,Kn.height,0,Te,xe,Kn.data)}}else{Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,xe,oe[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Te,xe,oe[Ce]);for(let ht=0;ht<tt.length;ht++){let Gt=tt[ht];Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,Te,xe,Gt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,Te,xe,Gt.image[Ce])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),_e.__version=ae.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Ot(C,S,q,ue,ae,_e){let ye=r.convert(q.format,q.colorSpace),ne=r.convert(q.type),re=A(q.internalFormat,ye,ne,q.normalized,q.colorSpace),me=n.get(S),U=n.get(q);if(U.__renderTarget=S,!me.__hasExternalTextures){let oe=Math.max(1,S.width>>_e),ie=Math.max(1,S.height>>_e);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,re,oe,ie,S.depth,0,ye,ne,null):t.texImage2D(ae,_e,re,oe,ie,0,ye,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,ae,U.__webglTexture,0,lt(S)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,ae,U.__webglTexture,_e),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Rn(C,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,C),S.depthBuffer){let ue=S.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=x(S.stencilBuffer,ae),ye=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),_e,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),_e,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,_e,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,C)}else{let ue=S.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ye=r.convert(_e.format,_e.colorSpace),ne=r.convert(_e.type),re=A(_e.internalFormat,ye,ne,_e.normalized,_e.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),re,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),re,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,re,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Mt(C,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(S.depthTexture);ae.__renderTarget=S;let _e=ue?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||_e.width!==S.width||_e.height!==S.height)&&(_e.width=S.width,_e.height=S.height,S.depthTexture.needsUpdate=!0),ue?Me(S.depthTexture,0):ge(S.depthTexture,0);let ye=ae.__webglTexture,ne=lt(S),re=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,me=S.depthTexture.format===qs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Fs)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,re,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,re,ye,0);else if(S.depthTexture.format===qs)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,re,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,re,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(C){let S=n.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ue=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=ue}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)Mt(S.__webglFramebuffer[ue],C,ue);else C.texture.mipmaps.length>0?Mt(S.__webglFramebuffer[0],C,0):Mt(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=i.createRenderbuffer(),Rn(S.__webglDepthbuffer[ue],C,!1);else{let ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Rn(S.__webglDepthbuffer,C,!1);else{let ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Qt(C,S,q){let ue=n.get(C);S!==void 0&&Ot(ue.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&xn(C)}function hn(C){let S=C.texture,q=n.get(C),ue=n.get(S);C.addEventListener("dispose",G),k(C);let ae=C.textures,_e=C.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=S.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let re=0;re<S.mipmaps.length;re++)q.__webglFramebuffer[ne][re]=i.createFramebuffer()}else q.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)q.__webglFramebuffer[ne]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(ye)for(let ne=0,re=ae.length;ne<re;ne++){let me=n.get(ae[ne]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let re=ae[ne];q.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let me=r.convert(re.format,re.colorSpace),U=r.convert(re.type),oe=A(re.internalFormat,me,U,re.normalized,re.colorSpace,C.isXRRenderTarget===!0),ie=lt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Rn(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(i.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot(q.__webglFramebuffer[ne][re],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else Ot(q.__webglFramebuffer[ne],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ne=0,re=ae.length;ne<re;ne++){let me=ae[ne],U=n.get(me),oe=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(oe=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,U.__webglTexture),pt(oe,me),Ot(q.__webglFramebuffer,C,me,i.COLOR_ATTACHMENT0+ne,oe,0),M(me)&&b(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ne=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,ue.__webglTexture),pt(ne,S),S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot(q.__webglFramebuffer[re],C,S,i.COLOR_ATTACHMENT0,ne,re);else Ot(q.__webglFramebuffer,C,S,i.COLOR_ATTACHMENT0,ne,0);M(S)?b(ne):S.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&xn(C)}function F(C){let S=C.textures;for(let q=0,ue=S.length;q<ue;q++){let ae=S[q];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let _e=R(C),ye=n.get(ae).__webglTexture;t.bindTexture(_e,ye),b(_e),t.unbindTexture()}}}let Pe=[];function Je(C){if(C.samples>0){if(we(C)===!1){let S=C.textures,q=C.width,ue=C.height,ae=i.COLOR_BUFFER_BIT,_e=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(C),ne=S.length>1;if(ne)for(let me=0;me<S.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<S.length;me++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let U=n.get(S[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,i.NEAREST),c===!0&&(Pe.length=0,Pe.push(i.COLOR_ATTACHMENT0+me),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Pe.push(_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<S.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let U=n.get(S[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&c){let S=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function lt(C){return Math.min(s.maxSamples,C.samples)}function we(C){let S=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ft(C){let S=o.render.frame;h.get(C)!==S&&(h.set(C,S),C.update())}function Ge(C,S){let q=C.colorSpace,ue=C.format,ae=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==ti&&q!==$s&&(mt.getTransfer(q)===Ct?(ue!==Ui||ae!==ci)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),S}function Ze(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.height),l}this.allocateTextureUnit=de,this.resetTextureUnits=ee,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ve,this.setTexture3D=Re,this.setTextureCube=Me,this.rebindTextures=Qt,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=H}function OT(i,e){function t(n,s=$s){let r,o=mt.getTransfer(s);if(n===ci)return i.UNSIGNED_BYTE;if(n===ih)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===pf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===mf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===df)return i.BYTE;if(n===ff)return i.SHORT;if(n===Jo)return i.UNSIGNED_SHORT;if(n===nh)return i.INT;if(n===ji)return i.UNSIGNED_INT;if(n===yi)return i.FLOAT;if(n===Zi)return i.HALF_FLOAT;if(n===gf)return i.ALPHA;if(n===xf)return i.RGB;if(n===Ui)return i.RGBA;if(n===Fs)return i.DEPTH_COMPONENT;if(n===qs)return i.DEPTH_STENCIL;if(n===rh)return i.RED;if(n===oh)return i.RED_INTEGER;if(n===gr)return i.RG;if(n===ah)return i.RG_INTEGER;if(n===lh)return i.RGBA_INTEGER;if(n===ml||n===gl||n===xl||n===_l)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ml)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===_l)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ml)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===xl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===_l)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ch||n===hh||n===uh||n===dh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ch)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===hh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===uh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===dh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===fh||n===ph||n===mh||n===gh||n===xh||n===vl||n===_h)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===fh||n===ph)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===mh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===gh)return r.COMPRESSED_R11_EAC;if(n===xh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===vl)return r.COMPRESSED_RG11_EAC;if(n===_h)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===vh||n===yh||n===bh||n===Sh||n===Mh||n===wh||n===Th||n===Eh||n===Ah||n===Rh||n===Ch||n===Ph||n===Ih||n===Lh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===vh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===yh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===bh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Sh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Mh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Th)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Eh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ah)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Rh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ch)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ph)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ih)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Lh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Nh||n===Dh||n===Oh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Nh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Dh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Oh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Uh||n===Fh||n===yl||n===kh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Uh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===yl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===qr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var UT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,FT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,zf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new tl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ps({vertexShader:UT,fragmentShader:FT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ln(new nl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Hf=class extends Ki{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new zf,m={},y=t.getContextAttributes(),M=null,b=null,R=[],A=[],x=new Ke,E=null,k=null,D=new yn;D.viewport=new Dt;let L=new yn;L.viewport=new Dt;let G=[D,L],W=new Jc,O=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let ge=R[te];return ge===void 0&&(ge=new Uo,R[te]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(te){let ge=R[te];return ge===void 0&&(ge=new Uo,R[te]=ge),ge.getGripSpace()},this.getHand=function(te){let ge=R[te];return ge===void 0&&(ge=new Uo,R[te]=ge),ge.getHandSpace()};function Y(te){let ge=A.indexOf(te.inputSource);if(ge===-1)return;let ve=R[ge];ve!==void 0&&(ve.update(te.inputSource,te.frame,l||o),ve.dispatchEvent({type:te.type,data:te.inputSource}))}function B(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ce);for(let te=0;te<R.length;te++){let ge=A[te];ge!==null&&(A[te]=null,R[te].disconnect(ge))}O=null,H=null,g.reset();for(let te in m)delete m[te];if(e.setRenderTarget(M),f=null,d=null,u=null,s=null,b=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),k!==null){let te=k.camera;te.fov=k.fov,te.zoom=k.zoom,te.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,n.isPresenting===!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,n.isPresenting===!0&&qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(te){l=te},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ce),y.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Re=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=y.stencil?qs:Fs,Re=y.stencil?qr:ji);let $e={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer($e),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new vi(d.textureWidth,d.textureHeight,{format:Ui,type:ci,depthTexture:new zs(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new vi(f.framebufferWidth,f.framebufferHeight,{format:Ui,type:ci,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ce(te){for(let ge=0;ge<te.removed.length;ge++){let ve=te.removed[ge],Re=A.indexOf(ve);Re>=0&&(A[Re]=null,R[Re].disconnect(ve))}for(let ge=0;ge<te.added.length;ge++){let ve=te.added[ge],Re=A.indexOf(ve);if(Re===-1){for(let $e=0;$e<R.length;$e++)if($e>=A.length){A.push(ve),Re=$e;break}else if(A[$e]===null){A[$e]=ve,Re=$e;break}if(Re===-1)break}let Me=R[Re];Me&&Me.connect(ve)}}function Z(te,ge){ge===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(ge.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let ge=te.near,ve=te.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(ve=g.depthFar)),W.near=L.near=D.near=ge,W.far=L.far=D.far=ve,(O!==W.near||H!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),O=W.near,H=W.far),W.layers.mask=te.layers.mask|6,D.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let Re=te.parent,Me=W.cameras;Z(W,Re);for(let $e=0;$e<Me.length;$e++)Z(Me[$e],Re);W.projectionMatrix.copy(D.projectionMatrix),W.projectionMatrixInverse.copy(D.projectionMatrixInverse),k===null&&te.isPerspectiveCamera&&(k={camera:te,fov:te.fov,zoom:te.zoom}),ee(te,W,Re)};function ee(te,ge,ve){ve===null?te.matrix.copy(ge.matrixWorld):(te.matrix.copy(ve.matrixWorld),te.matrix.invert(),te.matrix.multiply(ge.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(ge.projectionMatrix),te.projectionMatrixInverse.copy(ge.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=Ur*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(te){c=te,d!==null&&(d.fixedFoveation=te),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=te)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(W)},this.getCameraTexture=function(te){return m[te]};let se=null;function fe(te,ge){if(h=ge.getViewerPose(l||o),p=ge,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Re=!1;ve.length!==W.cameras.length&&(W.cameras.length=0,Re=!0);for(let We=0;We<ve.length;We++){let pt=ve[We],ut=null;if(f!==null)ut=f.getViewport(pt);else{let Yt=u.getViewSubImage(d,pt);ut=Yt.viewport,We===0&&(e.setRenderTargetTextures(b,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(b))}let rt=G[We];rt===void 0&&(rt=new yn,rt.layers.enable(We),rt.viewport=new Dt,G[We]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),We===0&&(W.matrix.copy(rt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Re===!0&&W.cameras.push(rt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let We=u.getDepthInformation(ve[0]);We&&We.isValid&&We.texture&&g.init(We,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let We=0;We<ve.length;We++){let pt=ve[We].camera;if(pt){let ut=m[pt];ut||(ut=new tl,m[pt]=ut);let rt=u.getCameraImage(pt);ut.sourceTexture=rt}}}}for(let ve=0;ve<R.length;ve++){let Re=A[ve],Me=R[ve];Re!==null&&Me!==void 0&&Me.update(Re,ge,l||o)}se&&se(te,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let de=new K0;de.setAnimationLoop(fe),this.setAnimationLoop=function(te){se=te},this.dispose=function(){}}},kT=new ct,rx=new st;rx.set(-1,0,0,0,1,0,0,0,1);function BT(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,Rf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,M,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,y,M):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===si&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===si&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),M=y.envMap,b=y.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(kT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(rx),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,y,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=M*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===si&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function zT(i,e,t,n){let s={},r={};function o(y,M){let b=M.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(p(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",g));let R=M.program;n.updateUBOMapping(y,R);let A=e.render.frame;r[y.id]!==A&&(l(y),r[y.id]=A)}function c(y){let M=i.createBuffer(),b=y.__size,R=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,R),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function l(y){let M=s[y.id],b=y.uniforms,R=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let A=0,x=b.length;A<x;A++){let E=b[A];if(Array.isArray(E))for(let k=0,D=E.length;k<D;k++)h(E[k],A,k,R);else h(E,A,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,M,b,R){if(d(y,M,b,R)===!0){let A=y.__offset,x=y.value;if(Array.isArray(x)){let E=0;for(let k=0;k<x.length;k++){let D=x[k],L=v(D,!0);u(D,y.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function u(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function d(y,M,b,R){let A=y.value,x=M+"_"+b;if(Array.isArray(A)){R[x]===void 0&&(R[x]=[]);let E=R[x],k=!1;for(let D=0;D<A.length;D++)f(A[D],E,D)===!0&&(k=!0);return k}return f(A,R,x)}function f(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let R=M[b];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function p(y){let M=y.uniforms,b=0,R=16;for(let x=0,E=M.length;x<E;x++){let k=Array.isArray(M[x])?M[x]:[M[x]];for(let D=0,L=k.length;D<L;D++){let G=k[D],W=Array.isArray(G.value)?G.value:[G.value],O=Array.isArray(M[x])||Array.isArray(G.value),H=b;for(let B=0,ce=W.length;B<ce;B++){let Z=W[B],ee=v(Z,O),se=b%R,fe=se%ee.boundary,de=se+fe;b+=fe,de!==0&&R-de<ee.storage&&(b+=R-de),B===0&&(H=b),b+=ee.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((b-H)/Float32Array.BYTES_PER_ELEMENT),G.__offset=H}}let A=b%R;return A>0&&(b+=R-A),y.__size=b,y.__cache={},this}function v(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):qe("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let M=y.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var HT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ys=null;function VT(){return ys===null&&(ys=new zo(HT,16,16,gr,Zi),ys.name="DFG_LUT",ys.minFilter=bn,ys.magFilter=bn,ys.wrapS=Ii,ys.wrapT=Ii,ys.generateMipmaps=!1,ys.needsUpdate=!0),ys}var Wh=class{constructor(e={}){let{canvas:t=y0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ci}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([lh,ah,oh]),m=new Set([ci,ji,Jo,qr,ih,sh]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,A=null,x=[],E=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,G=null,W=null,O=null,H=null;this._outputColorSpace=vn;let Y=0,B=0,ce=null,Z=-1,ee=null,se=new Dt,fe=new Dt,de=null,te=new je(0),ge=0,ve=t.width,Re=t.height,Me=1,$e=null,at=null,We=new Dt(0,0,ve,Re),pt=new Dt(0,0,ve,Re),ut=!1,rt=new ur,Yt=new Bc,Ht=!1,cn=!1,Ot=new ct,Rn=new X,Mt=new Dt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function hn(){return ce===null?Me:1}let F=n;function Pe(T,z){return t.getContext(T,z)}let Je,lt,we,Ft,Ge,Ze,C,S,q,ue,ae,_e,ye,ne,re,me,U,oe,ie,Te,xe,Se,Xe;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),F===null){let z="webgl2";if(F=Pe(z,T),F===null)throw Pe(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(T){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+T.message),T}function et(){Je=new QM(F),Je.init(),xe=new OT(F,Je),lt=new VM(F,Je,e,xe),we=new NT(F,Je),lt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),W=F.createFramebuffer(),O=F.createFramebuffer(),H=F.createFramebuffer(),Ft=new nw(F),Ge=new vT,Ze=new DT(F,Je,we,Ge,lt,xe,Ft),C=new JM(D),S=new sb(F),Se=new zM(F,S),q=new ew(F,S,Ft,Se),ue=new sw(F,q,S,Se,Ft),oe=new iw(F,lt,Ze),re=new GM(Ge),ae=new _T(D,C,Je,lt,Se,re),_e=new BT(D,Ge),ye=new bT,ne=new AT(Je),U=new BM(D,C,we,ue,p,c),me=new LT(D,ue,lt),Xe=new zT(F,Ft,lt,we),ie=new HM(F,Je,Ft),Te=new tw(F,Je,Ft),Ft.programs=ae.programs,D.capabilities=lt,D.extensions=Je,D.properties=Ge,D.renderLists=ye,D.shadowMap=me,D.state=we,D.info=Ft}v!==ci&&(k=new ow(v,t.width,t.height,a,s,r));let he=new Hf(D,F);this.xr=he,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(T){T!==void 0&&(Me=T,this.setSize(ve,Re,!1))},this.getSize=function(T){return T.set(ve,Re)},this.setSize=function(T,z,Q=!0){if(he.isPresenting){qe("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Re=z,t.width=Math.floor(T*Me),t.height=Math.floor(z*Me),Q===!0&&(t.style.width=T+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(ve*Me,Re*Me).floor()},this.setDrawingBufferSize=function(T,z,Q){ve=T,Re=z,Me=Q,t.width=Math.floor(T*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(v===ci){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(We)},this.setViewport=function(T,z,Q,K){T.isVector4?We.set(T.x,T.y,T.z,T.w):We.set(T,z,Q,K),we.viewport(se.copy(We).multiplyScalar(hn()).round())},this.getScissor=function(T){return T.copy(pt)},this.setScissor=function(T,z,Q,K){T.isVector4?pt.set(T.x,T.y,T.z,T.w):pt.set(T,z,Q,K),we.scissor(fe.copy(pt).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(T){we.setScissorTest(ut=T)},this.setOpaqueSort=function(T){$e=T},this.setTransparentSort=function(T){at=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let K=0;if(T){let j=!1;if(ce!==null){let Ee=ce.texture.format;j=g.has(Ee)}if(j){let Ee=ce.texture.type,Ie=m.has(Ee),Ae=U.getClearColor(),Ne=U.getClearAlpha(),Ve=Ae.r,it=Ae.g,_t=Ae.b;Ie?(y[0]=Ve,y[1]=it,y[2]=_t,y[3]=Ne,F.clearBufferuiv(F.COLOR,0,y)):(M[0]=Ve,M[1]=it,M[2]=_t,M[3]=Ne,F.clearBufferiv(F.COLOR,0,M))}else K|=F.COLOR_BUFFER_BIT}z&&(K|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(K|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&F.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),G=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),U.dispose(),ye.dispose(),ne.dispose(),Ze.dispose(),Ge.dispose(),C.dispose(),ue.dispose(),q.dispose(),Se.dispose(),Xe.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",jl),he.removeEventListener("sessionend",ss),Ts.stop()};function ze(T){T.preventDefault(),Va("WebGLRenderer: Context Lost."),L=!0}function tt(){Va("WebGLRenderer: Context Restored."),L=!1;let T=Ft.autoReset,z=me.enabled,Q=me.autoUpdate,K=me.needsUpdate,j=me.type;et(),Ft.autoReset=T,me.enabled=z,me.autoUpdate=Q,me.needsUpdate=K,me.type=j}function Ce(T){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ht(T){let z=T.target;z.removeEventListener("dispose",ht),Gt(z)}function Gt(T){Kn(T),Ge.remove(T)}function Kn(T){let z=Ge.get(T).programs;z!==void 0&&(z.forEach(function(Q){ae.releaseProgram(Q)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,K,j,Ee){z===null&&(z=xn);let Ie=j.isMesh&&j.matrixWorld.determinantAffine()<0,Ae=Ta(T,z,Q,K,j);we.setMaterial(K,Ie);let Ne=Q.index,Ve=1;if(K.wireframe===!0){if(Ne=q.getWireframeAttribute(Q),Ne===void 0)return;Ve=2}let it=Q.drawRange,_t=Q.attributes.position,He=it.start*Ve,vt=(it.start+it.count)*Ve;Ee!==null&&(He=Math.max(He,Ee.start*Ve),vt=Math.min(vt,(Ee.start+Ee.count)*Ve)),Ne!==null?(He=Math.max(He,0),vt=Math.min(vt,Ne.count)):_t!=null&&(He=Math.max(He,0),vt=Math.min(vt,_t.count));let Zt=vt-He;if(Zt<0||Zt===1/0)return;Se.setup(j,K,Ae,Q,Ne);let It,Lt=ie;if(Ne!==null&&(It=S.get(Ne),Lt=Te,Lt.setIndex(It)),j.isMesh)K.wireframe===!0?(we.setLineWidth(K.wireframeLinewidth*hn()),Lt.setMode(F.LINES)):Lt.setMode(F.TRIANGLES);else if(j.isLine){let _n=K.linewidth;_n===void 0&&(_n=1),we.setLineWidth(_n*hn()),j.isLineSegments?Lt.setMode(F.LINES):j.isLineLoop?Lt.setMode(F.LINE_LOOP):Lt.setMode(F.LINE_STRIP)}else j.isPoints?Lt.setMode(F.POINTS):j.isSprite&&Lt.setMode(F.TRIANGLES);if(j.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let _n=j._multiDrawStarts,ke=j._multiDrawCounts,un=j._multiDrawCount,bt=Ne?S.get(Ne).bytesPerElement:1,As=Ge.get(K).currentProgram.getUniforms();for(let dn=0;dn<un;dn++)As.setValue(F,"_gl_DrawID",dn),Lt.render(_n[dn]/bt,ke[dn])}else if(j.isInstancedMesh)Lt.renderInstances(He,Zt,j.count);else if(Q.isInstancedBufferGeometry){let _n=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,ke=Math.min(Q.instanceCount,_n);Lt.renderInstances(He,Zt,ke)}else Lt.render(He,Zt)};function Sa(T,z,Q,K){G!==null&&T.isNodeMaterial&&G.setObject(K,T),Ht===!0&&re.setState(T,Q,!1),T.transparent===!0&&T.side===Di&&T.forceSinglePass===!1?(T.side=si,T.needsUpdate=!0,rs(T,z,K),T.side=xs,T.needsUpdate=!0,rs(T,z,K),T.side=Di):rs(T,z,K)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),G!==null&&G.renderStart(T,z,Q),A=ne.get(Q),A.init(z),E.push(A),Q.traverseVisible(function(j){j.isLight&&j.layers.test(z.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),T!==Q&&T.traverseVisible(function(j){j.isLight&&j.layers.test(z.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),A.setupLights(),G!==null&&G.updateLights(A.state.lightsArray),cn=this.localClippingEnabled,Ht=re.init(this.clippingPlanes,cn),Ht===!0&&re.setGlobalState(this.clippingPlanes,z),G!==null&&me.render(A.state.shadowsArray,Q,z);let K=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ee=j.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Ae=Ee[Ie];Sa(Ae,Q,z,j),K.add(Ae)}else Sa(Ee,Q,z,j),K.add(Ee)}),A=E.pop(),G!==null&&G.renderEnd(),K},this.compileAsync=function(T,z,Q=null){let K=this.compile(T,z,Q);return new Promise(j=>{function Ee(){if(K.forEach(function(Ie){let Ne=Ge.get(Ie).currentProgram;(Ne===void 0||Ne.isReady())&&K.delete(Ie)}),K.size===0){j(T);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let no=null;function nd(T){no&&no(T)}function jl(){Ts.stop()}function ss(){Ts.start()}let Ts=new K0;Ts.setAnimationLoop(nd),typeof self<"u"&&Ts.setContext(self),this.setAnimationLoop=function(T){no=T,he.setAnimationLoop(T),T===null?Ts.stop():Ts.start()},he.addEventListener("sessionstart",jl),he.addEventListener("sessionend",ss),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(T,z);let Q=he.enabled===!0&&he.isPresenting===!0,K=k!==null&&(ce===null||Q)&&k.begin(D,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(z),z=he.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,z,ce),A=ne.get(T,E.length),A.init(z),A.state.textureUnits=Ze.getTextureUnits(),E.push(A),Ot.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Yt.setFromArrayCamera(z):rt.setFromProjectionMatrix(Ot,Li,z.reversedDepth),cn=this.localClippingEnabled,Ht=re.init(this.clippingPlanes,cn),R=ye.get(T,x.length),R.init(),x.push(R),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=D.xr.getDepthSensingMesh();Ie!==null&&Es(Ie,z,-1/0,D.sortObjects)}Es(T,z,0,D.sortObjects),R.finish(),G!==null&&G.updateLights(A.state.lightsArray),D.sortObjects===!0&&R.sort($e,at),Qt=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,Qt&&U.addToRenderList(R,T),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&re.beginShadows();let j=A.state.shadowsArray;if(me.render(j,T,z),Ht===!0&&re.endShadows(),(K&&k.hasRenderPass())===!1){let Ie=R.opaque,Ae=R.transmissive;if(A.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Ae.length>0)for(let Ve=0,it=Ne.length;Ve<it;Ve++){let _t=Ne[Ve];Gi(Ie,Ae,T,_t)}Qt&&U.render(T);for(let Ve=0,it=Ne.length;Ve<it;Ve++){let _t=Ne[Ve];Ma(R,T,_t,_t.viewport)}}else Ae.length>0&&Gi(Ie,Ae,T,z),Qt&&U.render(T),Ma(R,T,z)}ce!==null&&B===0&&(Ze.updateMultisampleRenderTarget(ce),Ze.updateRenderTargetMipmap(ce)),K&&k.end(D),T.isScene===!0&&T.onAfterRender(D,T,z),Se.resetDefaultState(),Z=-1,ee=null,E.pop(),E.length>0?(A=E[E.length-1],Ze.setTextureUnits(A.state.textureUnits),Ht===!0&&re.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,G!==null&&G.renderEnd()};function Es(T,z,Q,K){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Ie=z.isArrayCamera?Yt:rt;if(!T.frustumCulled||T.intersectsFrustum(Ie)){K&&Mt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ot);let Ae=ue.update(T),Ne=T.material;Ne.visible&&R.push(T,Ae,Ne,Q,Mt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Ie=z.isArrayCamera?Yt:rt;if(!T.frustumCulled||T.intersectsFrustum(Ie)){let Ae=ue.update(T),Ne=T.material;if(K&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Mt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),Mt.copy(Ae.boundingSphere.center)),Mt.applyMatrix4(T.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ne)){let Ve=Ae.groups;for(let it=0,_t=Ve.length;it<_t;it++){let He=Ve[it],vt=Ne[He.materialIndex];vt&&vt.visible&&R.push(T,Ae,vt,Q,Mt.z,He,z)}}else Ne.visible&&R.push(T,Ae,Ne,Q,Mt.z,null,z)}}}let Ee=T.children;for(let Ie=0,Ae=Ee.length;Ie<Ae;Ie++)Es(Ee[Ie],z,Q,K)}function Ma(T,z,Q,K){let{opaque:j,transmissive:Ee,transparent:Ie}=T;A.setupLightsView(Q),Ht===!0&&re.setGlobalState(D.clippingPlanes,Q),K&&we.viewport(se.copy(K)),j.length>0&&en(j,z,Q),Ee.length>0&&en(Ee,z,Q),Ie.length>0&&en(Ie,z,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Gi(T,z,Q,K){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[K.id]===void 0){let He=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[K.id]=new vi(1,1,{generateMipmaps:!0,type:He?Zi:ci,minFilter:Oi,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[K.id],Ie=K.viewport||se;Ee.setSize(Ie.z*D.transmissionResolutionScale,Ie.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Ne=D.getActiveCubeFace(),Ve=D.getActiveMipmapLevel();D.setRenderTarget(Ee),D.getClearColor(te),ge=D.getClearAlpha(),ge<1&&D.setClearColor(16777215,.5),D.clear(),Qt&&U.render(Q);let it=D.toneMapping;D.toneMapping=_s;let _t=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),A.setupLightsView(K),Ht===!0&&re.setGlobalState(D.clippingPlanes,K),en(T,Q,K),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let vt=0,Zt=z.length;vt<Zt;vt++){let It=z[vt],{object:Lt,geometry:_n,material:ke,group:un}=It;if(ke.side===Di&&Lt.layers.test(K.layers)){let bt=ke.side;ke.side=si,ke.needsUpdate=!0,rn(Lt,Q,K,_n,ke,un),ke.side=bt,ke.needsUpdate=!0,He=!0}}He===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}D.setRenderTarget(Ae,Ne,Ve),D.setClearColor(te,ge),_t!==void 0&&(K.viewport=_t),D.toneMapping=it}function en(T,z,Q){let K=z.isScene===!0?z.overrideMaterial:null;for(let j=0,Ee=T.length;j<Ee;j++){let Ie=T[j],{object:Ae,geometry:Ne,group:Ve}=Ie,it=Ie.material;it.allowOverride===!0&&K!==null&&(it=K),Ae.layers.test(Q.layers)&&rn(Ae,z,Q,Ne,it,Ve)}}function rn(T,z,Q,K,j,Ee){G!==null&&j.isNodeMaterial&&G.setObject(T,j),T.onBeforeRender(D,z,Q,K,j,Ee),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(D,z,Q,K,T,Ee),j.transparent===!0&&j.side===Di&&j.forceSinglePass===!1?(j.side=si,j.needsUpdate=!0,D.renderBufferDirect(Q,z,K,j,T,Ee),j.side=xs,j.needsUpdate=!0,D.renderBufferDirect(Q,z,K,j,T,Ee),j.side=Di):D.renderBufferDirect(Q,z,K,j,T,Ee),T.onAfterRender(D,z,Q,K,j,Ee)}function on(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function rs(T,z,Q){z.isScene!==!0&&(z=xn);let K=Ge.get(T),j=A.state.lights,Ee=A.state.shadowsArray,Ie=j.state.version,Ae=ae.getParameters(T,j.state,Ee,z,Q,A.state.lightProbeGridArray),Ne=ae.getProgramCacheKey(Ae),Ve=K.programs;K.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,K.fog=z.fog;let it=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;K.envMap=C.get(T.envMap||K.environment,it),K.envMapRotation=K.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,Ve===void 0&&(T.addEventListener("dispose",ht),Ve=new Map,K.programs=Ve,K.programVariants=new Map);let _t=Ve.get(Ne);if(_t!==void 0){if(K.currentProgram===_t&&K.lightsStateVersion===Ie)return wa(T,Ae),_t}else Ae.uniforms=ae.getUniforms(T),G!==null&&T.isNodeMaterial&&G.build(T,Q,Ae),T.onBeforeCompile(Ae,D),_t=ae.acquireProgram(Ae,Ne),Ve.set(Ne,_t),K.uniforms=Ae.uniforms;let He=K.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(He.clippingPlanes=re.uniform),wa(T,Ae),K.needsLights=Js(T),K.lightsStateVersion=Ie,K.needsLights&&(He.ambientLightColor.value=j.state.ambient,He.lightProbe.value=j.state.probe,He.sunLights.value=j.state.sun,He.sunLightShadows.value=j.state.sunShadow,He.directionalLights.value=j.state.directional,He.directionalLightShadows.value=j.state.directionalShadow,He.spotLights.value=j.state.spot,He.spotLightShadows.value=j.state.spotShadow,He.rectAreaLights.value=j.state.rectArea,He.ltc_1.value=j.state.rectAreaLTC1,He.ltc_2.value=j.state.rectAreaLTC2,He.pointLights.value=j.state.point,He.pointLightShadows.value=j.state.pointShadow,He.hemisphereLights.value=j.state.hemi,He.sunShadowMatrix.value=j.state.sunShadowMatrix,He.sunShadowCascade.value=j.state.sunShadowCascade,He.directionalShadowMatrix.value=j.state.directionalShadowMatrix,He.spotLightMatrix.value=j.state.spotLightMatrix,He.spotLightMap.value=j.state.spotLightMap,He.pointShadowMatrix.value=j.state.pointShadowMatrix),K.numLightProbeGrids=on(A.state.lightProbeGridArray),K.currentProgram=_t,K.uniformsList=null,_t}function di(T,z,Q,K,j){let Ee=Ge.get(T),Ie=Ee.currentProgram.id+","+K+","+j,Ae=Ee.programVariants.get(Ie);return Ae===void 0?(Ae=rs(T,z,Q),Ee.programVariants.set(Ie,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=K,Ee.toneMapping=j),Ae}function Zs(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=ta.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function wa(T,z){let Q=Ge.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Ta(T,z,Q,K,j){z.isScene!==!0&&(z=xn),Ze.resetTextureUnits();let Ee=z.fog,Ie=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?z.environment:null,Ae=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:mt.workingColorSpace,Ne=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ve=C.get(K.envMap||Ie,Ne),it=K.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,_t=!!Q.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),He=!!Q.morphAttributes.position,vt=!!Q.morphAttributes.normal,Zt=!!Q.morphAttributes.color,It=_s;K.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(It=D.toneMapping);let Lt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,_n=Lt!==void 0?Lt.length:0,ke=Ge.get(K),un=A.state.lights;if(Ht===!0&&(cn===!0||T!==ee)){let Nt=T===ee&&K.id===Z;re.setState(K,T,Nt)}let bt=!1,As=!1;K.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==un.state.version||j.isBatchedMesh&&ke.batching===!1||!j.isBatchedMesh&&ke.batching===!0||j.isBatchedMesh&&ke.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&ke.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&ke.instancing===!1||!j.isInstancedMesh&&ke.instancing===!0||j.isSkinnedMesh&&ke.skinning===!1||!j.isSkinnedMesh&&ke.skinning===!0||j.isInstancedMesh&&ke.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&ke.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&ke.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&ke.instancingMorph===!1&&j.morphTexture!==null||ke.envMap!==Ve||K.fog===!0&&ke.fog!==Ee||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==re.numPlanes||ke.numIntersection!==re.numIntersection)||ke.vertexAlphas!==it||ke.vertexTangents!==_t||ke.morphTargets!==He||ke.morphNormals!==vt||ke.morphColors!==Zt||ke.morphTargetsCount!==_n||ke.numLightProbeGrids!==on(A.state.lightProbeGridArray)?bt=!0:(ke.outputColorSpace!==Ae||ke.toneMapping!==It)&&(As=!0):(bt=!0,ke.__version=K.version);let dn=ke.currentProgram;(bt===!0||As===!0)&&(dn=As===!0?di(K,z,j,Ae,It):rs(K,z,j),G&&K.isNodeMaterial&&G.onUpdateProgram(K,dn,ke));let ro=!1,os=!1,Rs=!1,dt=dn.getUniforms(),tn=ke.uniforms;if(we.useProgram(dn.program)&&(ro=!0,os=!0,Rs=!0),K.id!==Z&&(Z=K.id,os=!0),ro||ee!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),dt.setValue(F,"projectionMatrix",T.projectionMatrix),dt.setValue(F,"viewMatrix",T.matrixWorldInverse);let fn=dt.map.cameraPosition;fn!==void 0&&fn.setValue(F,Rn.setFromMatrixPosition(T.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(F,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&dt.setValue(F,"isOrthographic",T.isOrthographicCamera===!0),ee!==T&&(ee=T,os=!0,Rs=!0)}if(ke.needsLights&&(un.state.sunShadowMap.length>0&&dt.setValue(F,"sunShadowMap",un.state.sunShadowMap,Ze),un.state.directionalShadowMap.length>0&&dt.setValue(F,"directionalShadowMap",un.state.directionalShadowMap,Ze),un.state.spotShadowMap.length>0&&dt.setValue(F,"spotShadowMap",un.state.spotShadowMap,Ze),un.state.pointShadowMap.length>0&&dt.setValue(F,"pointShadowMap",un.state.pointShadowMap,Ze)),j.isSkinnedMesh){dt.setOptional(F,j,"bindMatrix"),dt.setOptional(F,j,"bindMatrixInverse");let Nt=j.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),dt.setValue(F,"boneTexture",Nt.boneTexture,Ze))}j.isBatchedMesh&&(dt.setOptional(F,j,"batchingTexture"),dt.setValue(F,"batchingTexture",j._matricesTexture,Ze),dt.setOptional(F,j,"batchingIdTexture"),dt.setValue(F,"batchingIdTexture",j._indirectTexture,Ze),dt.setOptional(F,j,"batchingColorTexture"),j._colorsTexture!==null&&dt.setValue(F,"batchingColorTexture",j._colorsTexture,Ze));let jn=Q.morphAttributes;if((jn.position!==void 0||jn.normal!==void 0||jn.color!==void 0)&&oe.update(j,Q,dn),(os||ke.receiveShadow!==j.receiveShadow)&&(ke.receiveShadow=j.receiveShadow,dt.setValue(F,"receiveShadow",j.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&z.environment!==null&&(tn.envMapIntensity.value=z.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=VT()),os){if(dt.setValue(F,"toneMappingExposure",D.toneMappingExposure),ke.needsLights&&io(tn,Rs),Ee&&K.fog===!0&&_e.refreshFogUniforms(tn,Ee),_e.refreshMaterialUniforms(tn,K,Me,Re,A.state.transmissionRenderTarget[T.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Nt=b,fn=0;for(let Gn of A.state.lightProbeGridArray)Gn.texture!==null&&(Nt.textures[fn]=Gn.texture,Nt.min[fn]=Gn.boundingBox.min,Nt.max[fn]=Gn.boundingBox.max,Nt.resolution[fn]=Gn.resolution,fn++);for(let Gn in Nt)Nt[Gn].length=fn;tn.probesSH.value=Nt.textures,tn.probesMin.value=Nt.min,tn.probesMax.value=Nt.max,tn.probesResolution.value=Nt.resolution}ta.upload(F,Zs(ke),tn,Ze)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(ta.upload(F,Zs(ke),tn,Ze),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&dt.setValue(F,"center",j.center),dt.setValue(F,"modelViewMatrix",j.modelViewMatrix),dt.setValue(F,"normalMatrix",j.normalMatrix),dt.setValue(F,"modelMatrix",j.matrixWorld),K.uniformsGroups!==void 0){let Nt=K.uniformsGroups;for(let fn=0,Gn=Nt.length;fn<Gn;fn++){let Zl=Nt[fn];Xe.update(Zl,dn),Xe.bind(Zl,dn)}}return dn}function io(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Js(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,z,Q){let K=Ge.get(T);K.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ge.get(T.texture).__webglTexture=z,Ge.get(T.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:Q,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=Ge.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ce=T,Y=z,B=Q;let K=null,j=!1,Ee=!1;if(T){let Ae=Ge.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Ae.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest,we.viewport(se),we.scissor(fe),we.setScissorTest(de),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)Ze.setupRenderTarget(T);else if(Ae.__hasExternalTextures)Ze.rebindTextures(T,Ge.get(T.texture).__webglTexture,Ge.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let it=T.depthTexture;if(Ae.__boundDepthTexture!==it){if(it!==null&&Ge.has(it)&&(T.width!==it.image.width||T.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(T)}}let Ne=T.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let Ve=Ge.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ve[z])?K=Ve[z][Q]:K=Ve[z],j=!0):T.samples>0&&Ze.useMultisampledRTT(T)===!1?K=Ge.get(T).__webglMultisampledFramebuffer:Array.isArray(Ve)?K=Ve[Q]:K=Ve,se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest}else se.copy(We).multiplyScalar(Me).floor(),fe.copy(pt).multiplyScalar(Me).floor(),de=ut;if(Q!==0&&(K=W),we.bindFramebuffer(F.FRAMEBUFFER,K)&&we.drawBuffers(T,K),we.viewport(se),we.scissor(fe),we.setScissorTest(de),j){let Ae=Ge.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ae.__webglTexture,Q)}else if(Ee){let Ae=z;for(let Ne=0;Ne<T.textures.length;Ne++){let Ve=Ge.get(T.textures[Ne]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ne,Ve.__webglTexture,Q,Ae)}}else if(T!==null&&Q!==0){let Ae=Ge.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,Q)}Z=-1};function so(T){let z=Ge.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=lt.textureFormatReadable(T.format),z.__typeReadable=lt.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,K,j,Ee,Ie,Ae=0){if(!(T&&T.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Ne=Ne[Ie],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){we.bindFramebuffer(F.FRAMEBUFFER,Ne);try{let Ve=T.textures[Ae],it=Ve.format,_t=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let He=so(Ve);if(He.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-K&&Q>=0&&Q<=T.height-j&&F.readPixels(z,Q,K,j,xe.convert(it),xe.convert(_t),Ee)}finally{let Ve=ce!==null?Ge.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,K,j,Ee,Ie,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Ne=Ne[Ie],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=T.width-K&&Q>=0&&Q<=T.height-j){we.bindFramebuffer(F.FRAMEBUFFER,Ne);let Ve=T.textures[Ae],it=Ve.format,_t=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let He=so(Ve);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,vt),F.bufferData(F.PIXEL_PACK_BUFFER,Ee.byteLength,F.STREAM_READ),F.readPixels(z,Q,K,j,xe.convert(it),xe.convert(_t),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Zt=ce!==null?Ge.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Zt);let It=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await S0(F,It,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,vt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ee),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(vt),F.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let K=Math.pow(2,-Q),j=Math.floor(T.image.width*K),Ee=Math.floor(T.image.height*K),Ie=z!==null?z.x:0,Ae=z!==null?z.y:0;Ze.setTexture2D(T,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Ie,Ae,j,Ee),we.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,K=null,j=0,Ee=0){let Ie,Ae,Ne,Ve,it,_t,He,vt,Zt,It=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Ae=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,Ve=Q.min.x,it=Q.min.y,_t=Q.isBox3?Q.min.z:0;else{let dt=Math.pow(2,-j);Ie=Math.floor(It.width*dt),Ae=Math.floor(It.height*dt),T.isDataArrayTexture?Ne=It.depth:T.isData3DTexture?Ne=Math.floor(It.depth*dt):Ne=1,Ve=0,it=0,_t=0}K!==null?(He=K.x,vt=K.y,Zt=K.z):(He=0,vt=0,Zt=0);let Lt=xe.convert(z.format),_n=xe.convert(z.type),ke;z.isData3DTexture?(Ze.setTexture3D(z,0),ke=F.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),ke=F.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),ke=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,z.unpackAlignment);let un=we.getParameter(F.UNPACK_ROW_LENGTH),bt=we.getParameter(F.UNPACK_IMAGE_HEIGHT),As=we.getParameter(F.UNPACK_SKIP_PIXELS),dn=we.getParameter(F.UNPACK_SKIP_ROWS),ro=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,It.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,It.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(F.UNPACK_SKIP_ROWS,it),we.pixelStorei(F.UNPACK_SKIP_IMAGES,_t);let os=T.isDataArrayTexture||T.isData3DTexture,Rs=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let dt=Ge.get(T),tn=Ge.get(z),jn=Ge.get(dt.__renderTarget),Nt=Ge.get(tn.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,jn.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let fn=0;fn<Ne;fn++)os&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(T).__webglTexture,j,_t+fn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(z).__webglTexture,Ee,Zt+fn)),F.blitFramebuffer(Ve,it,Ve+Ie,it+Ae,He,vt,He+Ie,vt+Ae,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Ge.has(T)){let dt=Ge.get(T),tn=Ge.get(z);we.bindFramebuffer(F.READ_FRAMEBUFFER,O),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,H);for(let jn=0;jn<Ne;jn++)os?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,dt.__webglTexture,j,_t+jn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,dt.__webglTexture,j),Rs?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,tn.__webglTexture,Ee,Zt+jn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,tn.__webglTexture,Ee),j!==0?F.blitFramebuffer(Ve,it,Ve+Ie,it+Ae,He,vt,He+Ie,vt+Ae,F.COLOR_BUFFER_BIT,F.NEAREST):Rs?F.copyTexSubImage3D(ke,Ee,He,vt,Zt+jn,Ve,it,Ie,Ae):F.copyTexSubImage2D(ke,Ee,He,vt,Ve,it,Ie,Ae);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Rs?T.isDataTexture||T.isData3DTexture?F.texSubImage3D(ke,Ee,He,vt,Zt,Ie,Ae,Ne,Lt,_n,It.data):z.isCompressedArrayTexture?F.compressedTexSubImage3D(ke,Ee,He,vt,Zt,Ie,Ae,Ne,Lt,It.data):F.texSubImage3D(ke,Ee,He,vt,Zt,Ie,Ae,Ne,Lt,_n,It):T.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ee,He,vt,Ie,Ae,Lt,_n,It.data):T.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ee,He,vt,It.width,It.height,Lt,It.data):F.texSubImage2D(F.TEXTURE_2D,Ee,He,vt,Ie,Ae,Lt,_n,It);we.pixelStorei(F.UNPACK_ROW_LENGTH,un),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,bt),we.pixelStorei(F.UNPACK_SKIP_PIXELS,As),we.pixelStorei(F.UNPACK_SKIP_ROWS,dn),we.pixelStorei(F.UNPACK_SKIP_IMAGES,ro),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&F.generateMipmap(ke),we.unbindTexture()},this.initRenderTarget=function(T){Ge.get(T).__webglFramebuffer===void 0&&Ze.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ze.setTextureCube(T,0):T.isData3DTexture?Ze.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ze.setTexture2DArray(T,0):Ze.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){Y=0,B=0,ce=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Li}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};var ox={type:"change"},Gf={type:"start"},lx={type:"end"},$h=new fs,ax=new Bn,GT=Math.cos(70*ea.DEG2RAD),wn=new X,hi=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Vf=1e-6,Yh=class extends fl{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:pr.ROTATE,MIDDLE:pr.DOLLY,RIGHT:pr.PAN},this.touches={ONE:mr.ROTATE,TWO:mr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new On,this._lastTargetPosition=new X,this._quat=new On().setFromUnitVectors(e.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $o,this._sphericalDelta=new $o,this._scale=1,this._panOffset=new X,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new X,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=XT.bind(this),this._onPointerDown=WT.bind(this),this._onPointerUp=qT.bind(this),this._onContextMenu=QT.bind(this),this._onMouseWheel=KT.bind(this),this._onKeyDown=jT.bind(this),this._onTouchStart=ZT.bind(this),this._onTouchMove=JT.bind(this),this._onMouseDown=$T.bind(this),this._onMouseMove=YT.bind(this),this._interceptControlDown=eE.bind(this),this._interceptControlUp=tE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ox),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wn.copy(t).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=hi:n>Math.PI&&(n-=hi),s<-Math.PI?s+=hi:s>Math.PI&&(s-=hi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),t.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new X(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):($h.origin.copy(this.object.position),$h.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot($h.direction))<GT?this.object.lookAt(this.target):(ax.setFromNormalAndCoplanarPoint(this.object.up,this.target),$h.intersectPlane(ax,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Vf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Vf||this._lastTargetPosition.distanceToSquared(this.target)>Vf?(this.dispatchEvent(ox),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?hi/60*this.autoRotateSpeed*e:hi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wn.setFromMatrixColumn(t,0),wn.multiplyScalar(-e),this._panOffset.add(wn)}_panUp(e,t){this.screenSpacePanning===!0?wn.setFromMatrixColumn(t,1):(wn.setFromMatrixColumn(t,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(e),this._panOffset.add(wn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function WT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function XT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function qT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(lx),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function $T(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case pr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case pr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case pr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Gf)}function YT(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function KT(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(Gf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(lx))}function jT(i){this.enabled!==!1&&this._handleKeyDown(i)}function ZT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case mr.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case mr.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case mr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case mr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Gf)}function JT(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function QT(i){this.enabled!==!1&&i.preventDefault()}function eE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function tE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Wf(i,e){if(e===_f)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===Qo||e===bl){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===Qo)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function cx(i){let e=new Map,t=new Map,n=i.clone();return hx(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(c){return t.get(c)}),r.bind(r.skeleton,r.bindMatrix)}),n}function hx(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)hx(i.children[n],e.children[n],t)}var Kh=class extends gs{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new Zf(t)}),this.register(function(t){return new Jf(t)}),this.register(function(t){return new Qf(t)}),this.register(function(t){return new lp(t)}),this.register(function(t){return new cp(t)}),this.register(function(t){return new hp(t)}),this.register(function(t){return new tp(t)}),this.register(function(t){return new np(t)}),this.register(function(t){return new ip(t)}),this.register(function(t){return new sp(t)}),this.register(function(t){return new jf(t)}),this.register(function(t){return new rp(t)}),this.register(function(t){return new ep(t)}),this.register(function(t){return new ap(t)}),this.register(function(t){return new op(t)}),this.register(function(t){return new Yf(t)}),this.register(function(t){return new jh(t,xt.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new jh(t,xt.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new up(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let l=Xs.extractUrlBase(e);o=Xs.resolveURL(l,this.path)}else o=Xs.extractUrlBase(e);this.manager.itemStart(e);let a=function(l){s?s(l):console.error(l),r.manager.itemError(e),r.manager.itemEnd(e)},c=new Wo(this.manager);c.setPriority(this.priority),c.setCache(this.cache),c.setPath(this.path),c.setResponseType("arraybuffer"),c.setRequestHeader(this.requestHeader),c.setWithCredentials(this.withCredentials),c.load(e,function(l){try{r.parse(l,o,function(h){t(h),r.manager.itemEnd(e)},a)}catch(h){a(h)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},c=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(c.decode(new Uint8Array(e,0,4))===mx){try{o[xt.KHR_BINARY_GLTF]=new dp(e)}catch(u){s&&s(u);return}r=JSON.parse(o[xt.KHR_BINARY_GLTF].content)}else r=JSON.parse(c.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let l=new vp(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});l.fileLoader.setRequestHeader(this.requestHeader);for(let h=0;h<this.pluginCallbacks.length;h++){let u=this.pluginCallbacks[h](l);u.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[u.name]=u,o[u.name]=!0}if(r.extensionsUsed)for(let h=0;h<r.extensionsUsed.length;++h){let u=r.extensionsUsed[h],d=r.extensionsRequired||[];switch(u){case xt.KHR_MATERIALS_UNLIT:o[u]=new Kf;break;case xt.KHR_DRACO_MESH_COMPRESSION:o[u]=new fp(r,this.dracoLoader);break;case xt.KHR_TEXTURE_TRANSFORM:o[u]=new pp;break;case xt.KHR_MESH_QUANTIZATION:o[u]=new mp;break;default:d.indexOf(u)>=0&&a[u]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+u+'".')}}l.setExtensions(o),l.setPlugins(a),l.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function nE(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Jt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var xt={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},Yf=class{constructor(e){this.parser=e,this.name=xt.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,c=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],l,h=new je(16777215);c.color!==void 0&&h.setRGB(c.color[0],c.color[1],c.color[2],ti);let u=c.range!==void 0?c.range:0;switch(c.type){case"directional":l=new zr(h),l.target.position.set(0,0,-1),l.add(l.target);break;case"point":l=new hl(h),l.distance=u;break;case"spot":l=new cl(h),l.distance=u,c.spot=c.spot||{},c.spot.innerConeAngle=c.spot.innerConeAngle!==void 0?c.spot.innerConeAngle:0,c.spot.outerConeAngle=c.spot.outerConeAngle!==void 0?c.spot.outerConeAngle:Math.PI/4,l.angle=c.spot.outerConeAngle,l.penumbra=1-c.spot.innerConeAngle/c.spot.outerConeAngle,l.target.position.set(0,0,-1),l.add(l.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+c.type)}return l.position.set(0,0,0),Ss(l,c),c.intensity!==void 0&&(l.intensity=c.intensity),l.name=t.createUniqueName(c.name||"light_"+e),s=Promise.resolve(l),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(c){return n._getNodeRef(t.cache,a,c)})}},Kf=class{constructor(){this.name=xt.KHR_MATERIALS_UNLIT}getMaterialType(){return Ni}extendParams(e,t,n){let s=[];e.color=new je(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],ti),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,vn))}return Promise.all(s)}},jf=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},Zf=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new Ke(r,r)}return Promise.all(s)}},Jf=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},Qf=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},ep=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},tp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_SHEEN}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new je(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],ti)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,vn)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},np=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},ip=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_VOLUME}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new je().setRGB(r[0],r[1],r[2],ti),Promise.all(s)}},sp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_IOR}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},rp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new je().setRGB(r[0],r[1],r[2],ti),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,vn)),Promise.all(s)}},op=class{constructor(e){this.parser=e,this.name=xt.EXT_MATERIALS_BUMP}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},ap=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Jt(this.parser,e,this.name)!==null?ii:null}extendMaterialParams(e,t){let n=Jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},lp=class{constructor(e){this.parser=e,this.name=xt.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},cp=class{constructor(e){this.parser=e,this.name=xt.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],c=n.textureLoader;if(a.uri){let l=n.options.manager.getHandler(a.uri);l!==null&&(c=l)}return n.loadTextureImage(e,o.source,c)}},hp=class{constructor(e){this.parser=e,this.name=xt.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],c=n.textureLoader;if(a.uri){let l=n.options.manager.getHandler(a.uri);l!==null&&(c=l)}return n.loadTextureImage(e,o.source,c)}},jh=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let c=s.byteOffset||0,l=s.byteLength||0,h=s.count,u=s.byteStride,d=new Uint8Array(a,c,l);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(h,u,d,s.mode,s.filter).then(function(f){return f.buffer}):o.ready.then(function(){let f=new ArrayBuffer(h*u);return o.decodeGltfBuffer(new Uint8Array(f),h,u,d,s.mode,s.filter),f})})}else return null}},up=class{constructor(e){this.name=xt.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let l of s.primitives)if(l.mode!==Fi.TRIANGLES&&l.mode!==Fi.TRIANGLE_STRIP&&l.mode!==Fi.TRIANGLE_FAN&&l.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],c={};for(let l in o)a.push(this.parser.getDependency("accessor",o[l]).then(h=>(c[l]=h,c[l])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(l=>{let h=l.pop(),u=h.isGroup?h.children:[h],d=l[0].count,f=[];for(let p of u){let v=new ct,g=new X,m=new On,y=new X(1,1,1),M=new Ka(p.geometry,p.material,d);for(let R=0;R<d;R++)c.TRANSLATION&&g.fromBufferAttribute(c.TRANSLATION,R),c.ROTATION&&m.fromBufferAttribute(c.ROTATION,R),c.SCALE&&y.fromBufferAttribute(c.SCALE,R),M.setMatrixAt(R,v.compose(g,m,y));let b=null;for(let R in c)if(R==="_COLOR_0"){let A=c[R];M.instanceColor=new Bs(A.array,A.itemSize,A.normalized)}else if(R!=="TRANSLATION"&&R!=="ROTATION"&&R!=="SCALE"){if(b===null){let x=M.geometry;b=new ni,b.name=x.name;for(let E in x.attributes)b.setAttribute(E,x.attributes[E]);for(let E in x.morphAttributes)b.morphAttributes[E]=x.morphAttributes[E];x.index!==null&&b.setIndex(x.index),b.morphTargetsRelative=x.morphTargetsRelative;for(let E of x.groups)b.addGroup(E.start,E.count,E.materialIndex);x.boundingBox!==null&&(b.boundingBox=x.boundingBox.clone()),x.boundingSphere!==null&&(b.boundingSphere=x.boundingSphere.clone()),b.drawRange.start=x.drawRange.start,b.drawRange.count=x.drawRange.count,b.userData=Object.assign({},x.userData),M.geometry=b}let A=c[R];b.setAttribute(R,new Bs(A.array,A.itemSize,A.normalized))}jt.prototype.copy.call(M,p),this.parser.assignFinalMaterial(M),f.push(M)}return h.isGroup?(h.clear(),h.add(...f),h):f[0]}))}},mx="glTF",El=12,ux={JSON:1313821514,BIN:5130562},dp=class{constructor(e){this.name=xt.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,El),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==mx)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-El,r=new DataView(e,El),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let c=r.getUint32(o,!0);if(o+=4,c===ux.JSON){let l=new Uint8Array(e,El+o,a);this.content=n.decode(l)}else if(c===ux.BIN){let l=El+o;this.body=e.slice(l,l+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},fp=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=xt.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},c={},l={};for(let h in o){let u=xp[h]||h.toLowerCase();a[u]=o[h]}for(let h in e.attributes){let u=xp[h]||h.toLowerCase();if(o[h]!==void 0){let d=n.accessors[e.attributes[h]],f=ia[d.componentType];l[u]=f.name,c[u]=d.normalized===!0}}return t.getDependency("bufferView",r).then(function(h){return new Promise(function(u,d){s.decodeDracoFile(h,function(f){for(let p in f.attributes){let v=f.attributes[p],g=c[p];g!==void 0&&(v.normalized=g)}u(f)},a,l,ti,d)})})}},pp=class{constructor(){this.name=xt.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},mp=class{constructor(){this.name=xt.KHR_MESH_QUANTIZATION}},Zh=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=a*2,l=a*3,h=s-t,u=(n-t)/h,d=u*u,f=d*u,p=e*l,v=p-l,g=-2*f+3*d,m=f-d,y=1-g,M=m-d+u;for(let b=0;b!==a;b++){let R=o[v+b+a],A=o[v+b+c]*h,x=o[p+b+a],E=o[p+b]*h;r[b]=y*R+M*A+g*x+m*E}return r}},iE=new On,gp=class extends Zh{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return iE.fromArray(r).normalize().toArray(r),r}},Fi={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},ia={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},dx={9728:an,9729:bn,9984:th,9985:Zo,9986:Xr,9987:Oi},fx={33071:Ii,33648:Po,10497:hr},Xf={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},xp={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},xr={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},sE={CUBICSPLINE:void 0,LINEAR:Or,STEP:Dr},qf={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function rE(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new kr({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:xs})),i.DefaultMaterial}function Yr(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Ss(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function oE(i,e,t){let n=!1,s=!1,r=!1;for(let l=0,h=e.length;l<h;l++){let u=e[l];if(u.POSITION!==void 0&&(n=!0),u.NORMAL!==void 0&&(s=!0),u.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],c=[];for(let l=0,h=e.length;l<h;l++){let u=e[l];if(n){let d=u.POSITION!==void 0?t.getDependency("accessor",u.POSITION):i.attributes.position;o.push(d)}if(s){let d=u.NORMAL!==void 0?t.getDependency("accessor",u.NORMAL):i.attributes.normal;a.push(d)}if(r){let d=u.COLOR_0!==void 0?t.getDependency("accessor",u.COLOR_0):i.attributes.color;c.push(d)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(c)]).then(function(l){let h=l[0],u=l[1],d=l[2];return n&&(i.morphAttributes.position=h),s&&(i.morphAttributes.normal=u),r&&(i.morphAttributes.color=d),i.morphTargetsRelative=!0,i})}function aE(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function lE(i){let e,t=i.extensions&&i.extensions[xt.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+$f(t.attributes):e=i.indices+":"+$f(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+$f(i.targets[n]);return e}function $f(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function _p(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function cE(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var hE=new ct,vp=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new nE,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let c=a.match(/Version\/(\d+)/);s=n&&c?parseInt(c[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new ol(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new dl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new Wo(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return Yr(r,a,s),Ss(a,s),Promise.all(n._invokeAll(function(c){return c.afterRoot&&c.afterRoot(a)})).then(function(){for(let c of a.scenes)c.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,c=o.length;a<c;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let c=this.associations.get(o);c!=null&&this.associations.set(a,c);for(let[l,h]of o.children.entries())r(h,a.children[l])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[xt.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(Xs.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=Xf[s.type],a=ia[s.componentType],c=s.normalized===!0,l=new a(s.count*o);return Promise.resolve(new zn(l,o,c))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],c=Xf[s.type],l=ia[s.componentType],h=l.BYTES_PER_ELEMENT,u=h*c,d=s.byteOffset||0,f=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,p=s.normalized===!0,v,g;if(f&&f!==u){let m=Math.floor(d/f),y="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+m+":"+s.count,M=t.cache.get(y);M||(v=new l(a,m*f,s.count*f/h),M=new Fo(v,f/h),t.cache.add(y,M)),g=new ko(M,c,d%f/h,p)}else a===null?v=new l(s.count*c):v=new l(a,d,s.count*c),g=new zn(v,c,p);if(s.sparse!==void 0){let m=Xf.SCALAR,y=ia[s.sparse.indices.componentType],M=s.sparse.indices.byteOffset||0,b=s.sparse.values.byteOffset||0,R=new y(o[1],M,s.sparse.count*m),A=new l(o[2],b,s.sparse.count*c);a!==null&&(g=new zn(g.array.slice(),g.itemSize,g.normalized)),g.normalized=!1;for(let x=0,E=R.length;x<E;x++){let k=R[x];if(g.setX(k,A[x*c]),c>=2&&g.setY(k,A[x*c+1]),c>=3&&g.setZ(k,A[x*c+2]),c>=4&&g.setW(k,A[x*c+3]),c>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}g.normalized=p}return g})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let c=n.manager.getHandler(o.uri);c!==null&&(a=c)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],c=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[c])return this.textureCache[c];let l=this.loadImageSource(t,n).then(function(h){h.flipY=!1,h.name=o.name||a.name||"",h.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(h.name=a.uri);let d=(r.samplers||{})[o.sampler]||{};return h.magFilter=dx[d.magFilter]||bn,h.minFilter=dx[d.minFilter]||Oi,h.wrapS=fx[d.wrapS]||hr,h.wrapT=fx[d.wrapT]||hr,h.generateMipmaps=!h.isCompressedTexture&&h.minFilter!==an&&h.minFilter!==bn,s.associations.set(h,{textures:e}),h}).catch(function(){return null});return this.textureCache[c]=l,l}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(d=>d.clone());let o=s.images[e],a=self.URL||self.webkitURL,c=o.uri||"",l=!1,h;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)h=n.getDependency("bufferView",o.bufferView).then(function(d){return new Promise(function(f,p){t.parse(d,f,p)})});else{if(o.bufferView!==void 0)c=n.getDependency("bufferView",o.bufferView).then(function(d){l=!0;let f=new Blob([d],{type:o.mimeType});return c=a.createObjectURL(f),c});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");h=Promise.resolve(c).then(function(d){return new Promise(function(f,p){let v=f;t.isImageBitmapLoader===!0&&(v=function(g){let m=new Un(g);m.needsUpdate=!0,f(m)}),t.load(Xs.resolveURL(d,r.path),v,void 0,p)})})}let u=h.then(function(d){return l===!0&&a.revokeObjectURL(c),Ss(d,o),d.userData.mimeType=o.mimeType||cE(o.uri),d}).catch(function(d){throw console.error("THREE.GLTFLoader: Couldn't load texture",c),d});return this.sourceCache[e]=u,u}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[xt.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[xt.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let c=r.associations.get(o);o=r.extensions[xt.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,c)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,c=this.cache.get(a);c||(c=new Vo,ai.prototype.copy.call(c,n),c.color.copy(n.color),c.map=n.map,c.sizeAttenuation=!1,this.cache.add(a,c)),n=c}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,c=this.cache.get(a);c||(c=new Ho,ai.prototype.copy.call(c,n),c.color.copy(n.color),c.map=n.map,this.cache.add(a,c)),n=c}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let c=this.cache.get(a);c||(c=n.clone(),r&&(c.vertexColors=!0),o&&(c.flatShading=!0),s&&(c.normalScale&&(c.normalScale.y*=-1),c.clearcoatNormalScale&&(c.clearcoatNormalScale.y*=-1)),this.cache.add(a,c),this.associations.set(c,this.associations.get(n))),n=c}e.material=n}getMaterialType(){return kr}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},c=r.extensions||{},l=[];if(c[xt.KHR_MATERIALS_UNLIT]){let u=s[xt.KHR_MATERIALS_UNLIT];o=u.getMaterialType(),l.push(u.extendParams(a,r,t))}else{let u=r.pbrMetallicRoughness||{};if(a.color=new je(1,1,1),a.opacity=1,Array.isArray(u.baseColorFactor)){let d=u.baseColorFactor;a.color.setRGB(d[0],d[1],d[2],ti),a.opacity=d[3]}u.baseColorTexture!==void 0&&l.push(t.assignTexture(a,"map",u.baseColorTexture,vn)),a.metalness=u.metallicFactor!==void 0?u.metallicFactor:1,a.roughness=u.roughnessFactor!==void 0?u.roughnessFactor:1,u.metallicRoughnessTexture!==void 0&&(l.push(t.assignTexture(a,"metalnessMap",u.metallicRoughnessTexture)),l.push(t.assignTexture(a,"roughnessMap",u.metallicRoughnessTexture))),o=this._invokeOne(function(d){return d.getMaterialType&&d.getMaterialType(e)}),l.push(Promise.all(this._invokeAll(function(d){return d.extendMaterialParams&&d.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=Di);let h=r.alphaMode||qf.OPAQUE;if(h===qf.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,h===qf.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==Ni&&(l.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new Ke(1,1),r.normalTexture.scale!==void 0)){let u=r.normalTexture.scale;a.normalScale.set(u,u)}if(r.occlusionTexture!==void 0&&o!==Ni&&(l.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==Ni){let u=r.emissiveFactor;a.emissive=new je().setRGB(u[0],u[1],u[2],ti)}return r.emissiveTexture!==void 0&&o!==Ni&&l.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,vn)),Promise.all(l).then(function(){let u=new o(a);return r.name&&(u.name=r.name),Ss(u,r),t.associations.set(u,{materials:e}),r.extensions&&Yr(s,u,r),u})}createUniqueName(e){let t=kt.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[xt.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(c){return px(c,a,t)})}let o=[];for(let a=0,c=e.length;a<c;a++){let l=e[a],h=lE(l),u=s[h];if(u)o.push(u.promise);else{let d;l.extensions&&l.extensions[xt.KHR_DRACO_MESH_COMPRESSION]?d=r(l):d=px(new ni,l,t),l.mode===Fi.TRIANGLE_STRIP?d=d.then(f=>Wf(f,bl)):l.mode===Fi.TRIANGLE_FAN&&(d=d.then(f=>Wf(f,Qo))),s[h]={primitive:l,promise:d},o.push(d)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let c=0,l=o.length;c<l;c++){let h=o[c].material===void 0?rE(this.cache):this.getDependency("material",o[c].material);a.push(h)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(c){let l=c.slice(0,c.length-1),h=c[c.length-1],u=[];for(let f=0,p=h.length;f<p;f++){let v=h[f],g=o[f],m,y=l[f];if(g.mode===Fi.TRIANGLES||g.mode===Fi.TRIANGLE_STRIP||g.mode===Fi.TRIANGLE_FAN||g.mode===void 0){let M=r.isSkinnedMesh===!0,b=v.hasAttribute("skinIndex")&&v.hasAttribute("skinWeight");M&&b===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),m=M&&b?new $a(v,y):new ln(v,y),m.isSkinnedMesh===!0&&m.normalizeSkinWeights()}else if(g.mode===Fi.LINES)m=new ja(v,y);else if(g.mode===Fi.LINE_STRIP)m=new Fr(v,y);else if(g.mode===Fi.LINE_LOOP)m=new Za(v,y);else if(g.mode===Fi.POINTS)m=new Ja(v,y);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+g.mode);Object.keys(m.geometry.morphAttributes).length>0&&aE(m,r),m.name=t.createUniqueName(r.name||"mesh_"+e),Ss(m,r),g.extensions&&Yr(s,m,g),t.assignFinalMaterial(m),u.push(m)}for(let f=0,p=u.length;f<p;f++)t.associations.set(u[f],{meshes:e,primitives:f});if(u.length===1)return r.extensions&&Yr(s,u[0],r),u[0];let d=new _i;r.extensions&&Yr(s,d,r),t.associations.set(d,{meshes:e});for(let f=0,p=u.length;f<p;f++)d.add(u[f]);return d})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new yn(ea.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new Br(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Ss(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],c=[];for(let l=0,h=o.length;l<h;l++){let u=o[l];if(u){a.push(u);let d=new ct;r!==null&&d.fromArray(r.array,l*16),c.push(d)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[l])}return new Ya(a,c)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],c=[],l=[],h=[];for(let u=0,d=s.channels.length;u<d;u++){let f=s.channels[u],p=s.samplers[f.sampler],v=f.target,g=v.node,m=s.parameters!==void 0?s.parameters[p.input]:p.input,y=s.parameters!==void 0?s.parameters[p.output]:p.output;v.node!==void 0&&(o.push(this.getDependency("node",g)),a.push(this.getDependency("accessor",m)),c.push(this.getDependency("accessor",y)),l.push(p),h.push(v))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(c),Promise.all(l),Promise.all(h)]).then(function(u){let d=u[0],f=u[1],p=u[2],v=u[3],g=u[4],m=[];for(let M=0,b=d.length;M<b;M++){let R=d[M],A=f[M],x=p[M],E=v[M],k=g[M];if(R===void 0)continue;R.updateMatrix&&R.updateMatrix();let D=n._createAnimationTracks(R,A,x,E,k);if(D)for(let L=0;L<D.length;L++)m.push(D[L])}let y=new rl(r,void 0,m);return Ss(y,s),y})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let c=0,l=s.weights.length;c<l;c++)a.morphTargetInfluences[c]=s.weights[c]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let l=0,h=a.length;l<h;l++)o.push(n.getDependency("node",a[l]));let c=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),c]).then(function(l){let h=l[0],u=l[1],d=l[2];d!==null&&h.traverse(function(f){f.isSkinnedMesh&&f.bind(d,hE)});for(let f=0,p=u.length;f<p;f++)h.add(u[f]);if(h.userData.pivot!==void 0&&u.length>0){let f=h.userData.pivot,p=u[0];h.pivot=new X().fromArray(f),h.position.x-=f[0],h.position.y-=f[1],h.position.z-=f[2],p.position.set(0,0,0),delete h.userData.pivot}return h})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],c=s._invokeOne(function(l){return l.createNodeMesh&&l.createNodeMesh(e)});return c&&a.push(c),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(l){return s._getNodeRef(s.cameraCache,r.camera,l)})),s._invokeAll(function(l){return l.createNodeAttachment&&l.createNodeAttachment(e)}).forEach(function(l){a.push(l)}),this.nodeCache[e]=Promise.all(a).then(function(l){let h;if(r.isBone===!0?h=new Bo:l.length>1?h=new _i:l.length===1?h=l[0]:h=new jt,h!==l[0])for(let u=0,d=l.length;u<d;u++)h.add(l[u]);if(r.name&&(h.userData.name=r.name,h.name=o),Ss(h,r),r.extensions&&Yr(n,h,r),r.matrix!==void 0){let u=new ct;u.fromArray(r.matrix),h.applyMatrix4(u)}else r.translation!==void 0&&h.position.fromArray(r.translation),r.rotation!==void 0&&h.quaternion.fromArray(r.rotation),r.scale!==void 0&&h.scale.fromArray(r.scale);if(!s.associations.has(h))s.associations.set(h,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let u=s.associations.get(h);s.associations.set(h,{...u})}return s.associations.get(h).nodes=e,h}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new _i;n.name&&(r.name=s.createUniqueName(n.name)),Ss(r,n),n.extensions&&Yr(t,r,n);let o=n.nodes||[],a=[];for(let c=0,l=o.length;c<l;c++)a.push(s.getDependency("node",o[c]));return Promise.all(a).then(function(c){for(let h=0,u=c.length;h<u;h++){let d=c[h];d.parent!==null?r.add(cx(d)):r.add(d)}let l=h=>{let u=new Map;for(let[d,f]of s.associations)(d instanceof ai||d instanceof Un)&&u.set(d,f);return h.traverse(d=>{let f=s.associations.get(d);f!=null&&u.set(d,f)}),u};return s.associations=l(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,c=[];function l(f){f.morphTargetInfluences&&c.push(f.name?f.name:f.uuid)}xr[r.path]===xr.weights?(l(e),e.isGroup&&e.children.forEach(l)):c.push(a);let h;switch(xr[r.path]){case xr.weights:h=Vs;break;case xr.rotation:h=Gs;break;case xr.translation:case xr.scale:h=dr;break;default:n.itemSize===1?h=Vs:h=dr;break}let u=s.interpolation!==void 0?sE[s.interpolation]:Or,d=this._getArrayFromAccessor(n);for(let f=0,p=c.length;f<p;f++){let v=new h(c[f]+"."+xr[r.path],t.array,d,u);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(v),o.push(v)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=_p(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof Gs?gp:Zh;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function uE(i,e,t){let n=e.attributes,s=new qn;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],c=a.min,l=a.max;if(c!==void 0&&l!==void 0){if(s.set(new X(c[0],c[1],c[2]),new X(l[0],l[1],l[2])),a.normalized){let h=_p(ia[a.componentType]);s.min.multiplyScalar(h),s.max.multiplyScalar(h)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new X,c=new X;for(let l=0,h=r.length;l<h;l++){let u=r[l];if(u.POSITION!==void 0){let d=t.json.accessors[u.POSITION],f=d.min,p=d.max;if(f!==void 0&&p!==void 0){if(c.setX(Math.max(Math.abs(f[0]),Math.abs(p[0]))),c.setY(Math.max(Math.abs(f[1]),Math.abs(p[1]))),c.setZ(Math.max(Math.abs(f[2]),Math.abs(p[2]))),d.normalized){let v=_p(ia[d.componentType]);c.multiplyScalar(v)}a.max(c)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new oi;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function px(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(c){i.setAttribute(a,c)})}for(let o in n){let a=xp[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return mt.workingColorSpace!==ti&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${mt.workingColorSpace}" not supported.`),Ss(i,e),uE(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?oE(i,e.targets,t):i})}function $(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n.append(...t),n}function I(i){let e=document.getElementById(i);if(!e)throw new Error(`no element ${i}`);return e}function Vt(i,e,t={}){let n=$("button",{type:"button",...t},i);return n.addEventListener("click",e),n}function Ue(i,e=4){if(!Number.isFinite(i))return"\u2013";let t=Math.abs(i);return t!==0&&(t<.001||t>=1e6)?i.toExponential(e-1).replace("-","\u2212"):String(Number(i.toPrecision(e))).replace("-","\u2212")}function bi(i){return i.replace("um","\xB5m").replace("^2","\xB2").replace("^3","\xB3")}function _r(i){return i.replace(/(\d) u(?=[NmVA]\b)/g,"$1 \xB5")}function bp(i,e=""){let t=$("a",{href:i,download:e,hidden:""});document.body.append(t),t.click(),t.remove()}function Si(i,e){let t=URL.createObjectURL(i);bp(t,e),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function Ji(i,e){let t=n=>{if(typeof n=="number")return String(n);let s=/^[=+@\t\r-]/.test(n)?`'${n}`:n;return/[",\n\r]/.test(s)?`"${s.replaceAll('"','""')}"`:s};Si(new Blob([i.map(n=>n.map(t).join(",")).join(`
`)+`
`],{type:"text/csv"}),e)}var Jh=new Map;function Sp(i,e){e&&Jh.has(i)||(clearTimeout(Jh.get(i)),Jh.delete(i),e?Jh.set(i,window.setTimeout(()=>i.classList.add("stale"),250)):i.classList.remove("stale"))}var yp=new Map;function Le(i){let e=yp.get(i);return e===void 0&&yp.set(i,e=getComputedStyle(document.documentElement).getPropertyValue(i).trim()),e}function gx(){yp.clear()}var Qh=[[68,1,84],[65,68,135],[42,120,142],[34,168,132],[122,209,81],[253,231,37]];function Al(i){let t=(document.documentElement.dataset.theme==="dark"?.22+.78*i:.86*i)*(Qh.length-1),n=Math.min(Math.floor(t),Qh.length-2);return`rgb(${Qh[n].map((r,o)=>Math.round(r+(t-n)*(Qh[n+1][o]-r))).join(",")})`}var Mp=18,wp=17,xx=4,dE=40,Yn=[27,10],_x=[Mp+wp+2*Yn[0]-Yn[1],Mp+wp+Yn[1]],eu=class{constructor(e,t,n){this.place=e;this.set=t;this.redraw=n}place;set;redraw;spans=[];middle=new X;inputs=new Map;measure(e,t){[this.spans,this.middle]=[e,t];for(let[n,s]of this.inputs)s.hidden=!e.some(r=>r.size===n);for(let{size:n,title:s,value:r}of e){let o=this.inputs.get(n)??this.input(n);o.title=this.set?`${s}, mm: type another one`:`${s}, mm`,o.setAttribute("aria-label",`${s}, mm`),o.dataset.shown=Ue(r),document.activeElement!==o&&(o.value=o.dataset.shown)}}refuse(e){this.inputs.get(e)?.setAttribute("aria-invalid","true")}input(e){let t=$("input",{type:"text",class:"dimension",inputmode:"decimal",autocomplete:"off","data-size":e});t.readOnly=!this.set;let n=()=>{t.removeAttribute("aria-invalid"),t.value=t.dataset.shown};return t.addEventListener("change",()=>{let s=t.value.replace("\u2212","-").replace(",",".").trim();t.removeAttribute("aria-invalid"),this.set?.(e,s===""||!Number.isFinite(Number(s))?t.value:Number(s))}),t.addEventListener("keydown",s=>{s.key==="Escape"&&(n(),t.blur())}),t.addEventListener("blur",()=>{n(),this.redraw()}),this.inputs.set(e,t),this.place.append(t),t}draw(e,t,n=!1){let s=this.place.clientWidth,r=this.place.clientHeight,o=[];if(!this.spans.length||!s)return;let a=l=>{let{x:h,y:u,z:d}=l.clone().project(t);return{x:(.5+.5*h)*s,y:(.5-.5*u)*r,behind:d>1}},c=a(this.middle);e.save(),e.setTransform(e.canvas.width/s,0,0,e.canvas.height/r,0,0);for(let l of this.spans){let h=([D,L],[G,W])=>Math.hypot(G.x+W.x-2*c.x,G.y+W.y-2*c.y)-Math.hypot(D.x+L.x-2*c.x,D.y+L.y-2*c.y),[u,d]=l.edges.map(D=>D.map(a)).sort(h)[0],f=this.inputs.get(l.size);if(f.style.visibility=u.behind||d.behind?"hidden":"",u.behind||d.behind)continue;let p=Math.hypot(d.x-u.x,d.y-u.y),v={x:(u.x+d.x)/2-c.x,y:(u.y+d.y)/2-c.y},[g,m]=p>6?[{x:(u.y-d.y)/p,y:(d.x-u.x)/p},1]:[v,Math.hypot(v.x,v.y)||1],y=g.x*v.x+g.y*v.y<0?-1:1,M={x:y*g.x/m,y:y*g.y/m},b=l.size==="pitch"?0:Mp,R=(D,L)=>[D.x+L*M.x,D.y+L*M.y];for(let[D,L]of[["--card",3.5],["--ink-soft",1.2]]){e.strokeStyle=Le(D),e.lineWidth=L,e.beginPath(),e.moveTo(...R(u,b)),e.lineTo(...R(d,b));let G=b&&p>dE?4:b-xx;for(let W of[u,d])e.moveTo(...R(W,G)),e.lineTo(...R(W,b+xx));e.stroke()}let[A,x]=R({x:(u.x+d.x)/2,y:(u.y+d.y)/2},b+wp+Math.abs(M.x)*(Yn[0]-Yn[1])),E=(D,L,G)=>Math.min(Math.max(D,L+2),G-L-2),k={x:E(A,Yn[0],s),y:E(x,Yn[1],r)};for(;o.some(D=>Math.abs(D.x-k.x)<2*Yn[0]&&Math.abs(D.y-k.y)<2*Yn[1])&&k.y>0;)k.y-=Yn[1];o.push(k),Object.assign(f.style,{left:`${k.x-Yn[0]}px`,top:`${k.y-Yn[1]}px`}),n&&(e.font="12px system-ui",[e.textAlign,e.textBaseline,e.fillStyle]=["center","middle",Le("--card")],e.fillRect(k.x-Yn[0],k.y-Yn[1],2*Yn[0],2*Yn[1]),e.fillStyle=Le("--ink"),e.fillText(f.dataset.shown,k.x,k.y))}e.restore()}};var fE=5,Tp=6e3;function Rl([i,e,t]){return new X(i/1e3,t/1e3,-e/1e3)}function vx({x:i,y:e,z:t}){return[1e3*i,-1e3*t,1e3*e]}var tu=class{constructor(e,t,n,s,r,o,a,c){this.place=e;this.sheet=t;this.camera=n;this.origin=s;this.take=r;this.turn=o;this.send=a;this.redraw=c;e.append(this.note),e.addEventListener("pointerdown",l=>this.begin(l),{capture:!0}),t.addEventListener("pointermove",l=>this.move(l));for(let l of["pointerup","pointercancel"])t.addEventListener(l,()=>this.end());addEventListener("keydown",l=>{l.key==="Escape"&&this.active&&(this.ask([0,0,0]),this.end())})}place;sheet;camera;origin;take;turn;send;redraw;active=!1;hold=null;plane=new Bn;down=[0,0];now=[0,0];held=0;gesture="";refused="";note=$("div",{id:"drag-note",role:"status",hidden:""});leaving=0;begin(e){e.target!==this.sheet||e.button!==0||!I("movable").checked||(this.hold=this.take(e),this.hold&&(this.turn(!1),this.sheet.setPointerCapture(e.pointerId),this.down=this.now=[e.clientX,e.clientY],this.plane.setFromNormalAndCoplanarPoint(this.hold.normal,this.hold.at),this.gesture=`drag-${++this.held}-${Date.now()}`))}move(e){if(!this.hold||!this.active&&Math.hypot(e.clientX-this.down[0],e.clientY-this.down[1])<fE)return;this.active=!0,this.now=[e.clientX,e.clientY];let t=this.sheet.getBoundingClientRect(),n=new Hr;n.setFromCamera(new Ke(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),this.camera);let s=n.ray.intersectPlane(this.plane,new X);s&&this.ask(vx(s.sub(this.hold.at)),e.shiftKey),this.redraw()}ask(e,t=!1){let n=vx(this.hold.at.clone().sub(this.origin()));this.send({do:"drag",part:this.hold.group,by:e,at:n,row:t,gesture:this.gesture})}end(){this.hold&&(this.turn(!0),this.hold=null,this.active=!1,clearTimeout(this.leaving),this.leaving=window.setTimeout(()=>{this.note.hidden=!0},this.refused?Tp:Tp/4),this.redraw())}say({words:e,refused:t}){clearTimeout(this.leaving),this.active||(this.leaving=window.setTimeout(()=>{this.note.hidden=!0},Tp)),this.refused=t,this.note.hidden=!1,this.note.classList.toggle("refused",t!==""),this.note.replaceChildren(...e?[$("strong",{},e)]:[],...t?[$("span",{},t)]:[]);let n=this.place.getBoundingClientRect(),[s,r]=[this.now[0]-n.left,this.now[1]-n.top],o=Math.min(Math.max(s+16,4),n.width-this.note.offsetWidth-4),a=r+20+this.note.offsetHeight<n.height;Object.assign(this.note.style,{left:`${o}px`,top:`${a?r+20:Math.max(r-20-this.note.offsetHeight,4)}px`})}draw(e,t){if(!this.active||!this.refused)return;let n=this.sheet.getBoundingClientRect(),s=this.sheet.width/n.width;e.save(),e.strokeStyle=Le("--bad"),e.lineWidth=2*s,e.setLineDash([6*s,4*s]),e.beginPath(),e.arc((this.now[0]-n.left)*s,(this.now[1]-n.top)*s,t,0,7),e.stroke(),e.restore()}};var yx={shell:"shells",membrane:"membranes",sheath:"tube sheaths",spring:"tube springs",housing:"microphone housings",board:"boards",package:"microphones",base:"base plate",body:"body"},pE={membrane:2.2,shell:0,sheath:-1.2,spring:1.1,housing:0,board:1.6,package:3},bx={membrane:"drag it to move it",housing:"drag it to another place or side",board:"drag it to another place or side",package:"drag it to another place or side",sheath:"drag its end to change its length",spring:"drag its end to change its length"},nu=class{constructor(e,t,n,s,r){this.place=e;this.colourOf=t;this.choose=n;this.hover=s;this.dimensions=new eu(e,r?.resize??null,()=>this.ask());try{this.renderer=new Wh({antialias:!0})}catch{e.append($("p",{class:"problem"},"This browser draws nothing in three dimensions (WebGL is off)."));return}let o=this.sheet;e.prepend(o),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.localClippingEnabled=!0,this.controls=new Yh(this.camera,o),this.controls.addEventListener("change",()=>this.ask()),this.controls.addEventListener("start",()=>{this.turned=!0});let a=new zr(16777215,1.6);if(a.position.set(.4,1,.7),this.scene.add(new al(16777215,9081500,1.6),new ul(16777215,.35),a,this.model),new ResizeObserver(()=>this.fit()).observe(e),new IntersectionObserver(l=>{this.inSight=l.at(-1).isIntersecting,this.inSight&&this.owed&&this.ask()}).observe(e),r){let l=h=>{this.controls.enabled=h};this.dragging=new tu(e,o,this.camera,()=>this.model.position,h=>this.hold(h),l,r.drag,()=>this.copy())}let c=[0,0];o.addEventListener("pointerdown",l=>{c=[l.clientX,l.clientY]}),o.addEventListener("pointermove",l=>{l.buttons||this.name(l)}),o.addEventListener("pointerleave",()=>this.hover(null)),o.addEventListener("click",l=>{Math.hypot(l.clientX-c[0],l.clientY-c[1])<5&&this.choose(this.pointOf(this.under(l)?.part??null),l.shiftKey)}),o.addEventListener("keydown",l=>this.key(l));for(let l of["exploded","section"])I(l).addEventListener("input",()=>this.arrange());I("dimensions").addEventListener("change",()=>{this.arrange(),this.see()}),I("refit").addEventListener("click",()=>this.see())}place;colourOf;choose;hover;renderer=null;scene=new Wa;camera=new yn(35,1,5e-4,20);controls=null;model=new _i;parts=new Map;home=new Map;hidden=new Set;marks=[];dimensions;dragging=null;moved=null;extent=new qn;fittedTo=0;turned=!1;cut=new Bn(new X(0,0,-1),0);lit=()=>!1;sheet=$("canvas",{tabindex:"0",role:"img","aria-label":"the array in three dimensions; arrow keys turn it, plus and minus zoom"});still=$("canvas");touched=null;pointed=null;recoloured=!1;later=0;asked=!1;inSight=!1;owed=!1;size=[0,0,0];get isDragged(){return this.dragging?.active??!1}get isMoved(){return this.moved!==null}async take(e,t){if(I("array-note").textContent=e.notes.join(" "),!this.renderer)return;let n=await fetch(e.file,{headers:tc()});if(!n.ok)throw new Error(`${e.file}: ${n.status}`);let s=await new Kh().parseAsync(await n.arrayBuffer(),"");if(this.moved&&t<this.moved.revision)return;this.moved?.revision===t&&this.model.position.add(Rl(this.moved.shift)),this.moved=null,this.clear(),this.parts=new Map(e.parts.map(o=>[o.label,o])),this.size=e.size,this.model.add(s.scene),this.home.clear(),s.scene.traverse(o=>{if(this.parts.has(o.name)&&this.home.set(o,{position:o.position.clone(),turn:o.quaternion.clone()}),!(o instanceof ln))return;let a=o.material.clone();a.userData={colour:a.color.clone(),opacity:a.opacity},o.material=a}),this.model.updateMatrixWorld(!0),this.extent.makeEmpty();for(let o of this.home.keys())["board","body"].includes(this.parts.get(o.name).kind)||this.extent.expandByObject(o,!0);this.switches(e.parts);let r=Math.hypot(...e.size);this.arrange(),Math.abs(Math.log(r/(this.fittedTo||1)))>.08&&this.see()}follow(e){this.dragging?.say(e),this.moved=e.words||this.moved?e:null,this.arrange()}light(e,t=[]){this.lit=e;for(let n of this.marks)n.removeFromParent(),n.geometry.dispose();this.marks=[];for(let[n]of this.home)for(let{part:s,place:r}of t){if(!r||this.parts.get(n.name)?.part!==s)continue;let o=new ln(new il(.35,12,8),new Ni({color:Le("--bad"),depthTest:!1,transparent:!0}));o.position.set(r[0],r[1],r[2]),o.renderOrder=5,n.add(o),this.marks.push(o)}this.arrange()}touch(e){this.touched=e,this.inSight?!this.asked&&this.renderer&&this.copy():this.owed=!0}point(e){e!==this.pointed&&(this.pointed=e,this.inSight&&!this.asked&&this.renderer&&this.copy())}recolour(){if(this.home.size){if(!this.inSight||this.asked||!this.renderer)return this.arrange();this.recoloured=!0,this.copy(),window.clearTimeout(this.later),this.later=window.setTimeout(()=>this.arrange(),150)}}thumbnail(){if(!this.renderer||!this.fittedTo)return"";let{width:e,height:t}=this.still,n=$("canvas",{width:"300",height:"168"}),s=n.getContext("2d");s.fillStyle=Le("--card"),s.fillRect(0,0,300,168);let r=Math.min(300/e,168/t);return s.drawImage(this.still,(300-r*e)/2,(168-r*t)/2,r*e,r*t),n.toDataURL("image/jpeg",.7)}picture(e){this.draw(),this.copy(!0),this.sheet.toBlob(t=>t&&Si(t,`${e}-array.png`))}restyle(){this.home.size?this.arrange():this.ask()}switches(e){let t=I("kinds"),n=new Set(e.map(r=>r.kind)),s=[...Object.keys(yx).filter(r=>n.delete(r)),...n];t.replaceChildren(...s.map(r=>{let o=$("input",{type:"checkbox"});return o.checked=!this.hidden.has(r),o.addEventListener("change",()=>{o.checked?this.hidden.delete(r):this.hidden.add(r),this.arrange()}),$("label",{},o,` ${yx[r]??r} (${e.filter(a=>a.kind===r).length})`)}))}arrange(){let e=Number(I("exploded").value)/100,t=Math.max(this.size[2],1)/1e3,n=Number(I("section").value)/100,s=this.extent;this.cut.constant=s.isEmpty()?1e3:s.max.z-n*(s.max.z-s.min.z)+(n===0?1:0);let r=new je(Le("--accent")),o=this.carried();for(let[h,{position:u,turn:d}]of this.home){let f=this.parts.get(h.name),p=o.get(f.group);h.visible=!this.hidden.has(f.kind)&&!(this.moved&&f.group.startsWith("tube ")),h.position.copy(u),h.quaternion.copy(d),p&&(h.position.sub(p.from).applyQuaternion(p.turn).add(p.to),h.quaternion.premultiply(p.turn)),h.position.y+=e*(pE[f.kind]??0)*t;let v=this.lit(f),g=f.kind==="membrane"?this.pointOf(f):null,m=g===null?null:new je(this.colourOf(g));h.traverse(y=>{if(!(y instanceof ln)||this.marks.includes(y))return;let M=y.material;M.clippingPlanes=n===0?[]:[this.cut],M.color.copy(v?r:m??M.userData.colour),M.emissive.copy(v?r:new je(0)),M.emissiveIntensity=v?.5:0,M.opacity=v||m?1:M.userData.opacity})}this.measure();let[a,c,l]=this.size;a&&(I("size").textContent=`${Ue(Math.max(a,c))} \xD7 ${Ue(Math.min(a,c))} \xD7 ${Ue(l)} mm`),this.ask()}carried(){let e=new Map;if(!this.moved)return e;for(let[t,{position:n,turn:s}]of this.home){let{kind:r,group:o}=this.parts.get(t.name),a=this.pointOf(this.parts.get(t.name)),c=r==="shell"&&a?this.moved.points[a-1]:r==="housing"?this.moved.microphones[o.replace("microphone ","")]:void 0;if(!c)continue;let l=new X(0,0,1).applyQuaternion(s),h=Rl(c.slice(3)).normalize();e.set(o,{from:n,to:Rl(c),turn:new On().setFromUnitVectors(l,h)})}return e}measure(){let{min:e,max:t}=this.extent,[n,s,r]=this.size;if(!I("dimensions").checked||this.extent.isEmpty()||this.moved)return this.dimensions.measure([],this.extent.min);this.place.dataset.measured=[t.x-e.x,t.z-e.z,t.y-e.y].map(d=>Ue(1e3*d,3)).join(" ");let o=(d,f,p)=>new X(d,f,p),a=[e,t],c=d=>a.flatMap(f=>a.map(p=>d(f,p))),l=[{size:"x",title:"length along x",edges:c((d,f)=>[o(e.x,d.y,f.z),o(t.x,d.y,f.z)]),value:n},{size:"y",title:"length along y",edges:c((d,f)=>[o(d.x,f.y,e.z),o(d.x,f.y,t.z)]),value:s},{size:"z",title:"height",edges:c((d,f)=>[o(d.x,e.y,f.z),o(d.x,t.y,f.z)]),value:r}],[h,u]=[1,2].map(d=>[...this.home].find(([f])=>{let p=this.parts.get(f.name);return p.kind==="membrane"&&p.group===`point ${d}`}));if(h&&u){let[d,f]=[h,u].map(([,p])=>p.position.clone().add(this.model.position));l.push({size:"pitch",title:"pitch, from point 1 to point 2",edges:[[d,f]],value:1e3*d.distanceTo(f)})}this.dimensions.measure(l,this.extent.getCenter(new X))}refuseSize(e){this.dimensions.refuse(e)}see(){let e=new qn().setFromObject(this.model);if(e.isEmpty()||!this.controls)return;let t=e.getCenter(new X),n=e.getSize(new X),s=Math.tan(this.camera.fov*Math.PI/360),r=I("dimensions").checked?_x:[0,0],[o,a]=[this.place.clientWidth,this.place.clientHeight].map((l,h)=>1.12*l/Math.max(l-2*r[h],l/3)),c=Math.max(o*n.x/(2*s*this.camera.aspect),a*(n.z*.75+n.y)/(2*s))+n.z/3;this.camera.position.copy(t).add(new X(0,.78,.62).normalize().multiplyScalar(c)),this.controls.target.copy(t),this.controls.update(),this.fittedTo=Math.hypot(...this.size),this.turned=!1,this.ask()}fit(){let e=this.place.clientWidth,t=this.place.clientHeight;if(!this.renderer||e===0||t===0)return;this.renderer.setSize(e,t,!1);let{width:n,height:s}=this.renderer.domElement;for(let r of[this.sheet,this.still])Object.assign(r,{width:n,height:s});Object.assign(this.sheet.style,{width:`${e}px`,height:`${t}px`}),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.turned||this.moved?this.ask():this.see()}ask(){this.owed=!this.inSight,!(this.asked||this.owed)&&(this.asked=!0,requestAnimationFrame(()=>{this.asked=!1,this.draw()}))}draw(){this.renderer&&(this.renderer.setClearColor(new je(Le("--card"))),this.renderer.render(this.scene,this.camera),Sx(this.still).drawImage(this.renderer.domElement,0,0),this.recoloured=!1,this.copy(),document.documentElement.dataset.drawn=String(Number(document.documentElement.dataset.drawn??0)+1))}copy(e=!1){let t=Sx(this.sheet);t.drawImage(this.still,0,0);for(let[n]of this.home){let s=this.parts.get(n.name);s.kind!=="membrane"||!n.visible||(this.recoloured&&this.fill(t,n,this.colourOf(this.pointOf(s))),s.group===`point ${this.touched}`?this.fill(t,n,Le("--accent")):s.group===`point ${this.pointed}`&&this.fill(t,n,Le("--accent"),.6))}document.documentElement.dataset.coloured=String(Number(document.documentElement.dataset.coloured??0)+Number(this.recoloured)),this.moved&&this.trace(t,this.moved),this.dimensions.draw(t,this.camera,e),this.dragging?.draw(t,14*(this.sheet.width/this.place.clientWidth))}trace(e,t){e.save(),e.strokeStyle=Le("--ink-soft"),e.lineWidth=2.5*(this.sheet.width/this.place.clientWidth),e.beginPath();for(let n of t.tubes)n.forEach((s,r)=>{let{x:o,y:a}=Rl(s).add(this.model.position).project(this.camera),c=[(.5+.5*o)*this.sheet.width,(.5-.5*a)*this.sheet.height];r?e.lineTo(...c):e.moveTo(...c)});e.stroke(),e.restore()}fill(e,t,n,s=1){e.beginPath(),t.traverse(r=>{if(!(r instanceof ln))return;let{index:o,attributes:{position:a}}=r.geometry,c=o?.count??a.count;for(let l=0;l<c;l+=3){let h=[0,1,2].map(y=>new X().fromBufferAttribute(a,o?o.getX(l+y):l+y).applyMatrix4(r.matrixWorld));if(h.some(y=>this.cut.distanceToPoint(y)<0))continue;let u=h.map(y=>y.project(this.camera)).map(({x:y,y:M})=>[(.5+.5*y)*this.sheet.width,(.5-.5*M)*this.sheet.height]),[[d,f],[p,v],[g,m]]=u;(p-d)*(m-f)<(g-d)*(v-f)&&u.reverse(),e.moveTo(u[0][0],u[0][1]),e.lineTo(u[1][0],u[1][1]),e.lineTo(u[2][0],u[2][1])}}),e.fillStyle=n,e.globalAlpha=s,e.fill(),e.globalAlpha=1}under(e){let t=this.sheet.getBoundingClientRect(),n=new Ke(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),s=new Hr;this.camera.updateMatrixWorld(),this.model.updateMatrixWorld(),s.setFromCamera(n,this.camera);for(let r of s.intersectObject(this.model,!0)){let o=r.object;for(;o&&!this.parts.has(o.name);)o=o.parent;let a=o&&this.parts.get(o.name);if(o?.visible&&a&&a.kind!=="body")return{part:a,hit:r}}return null}hold(e){let t=this.under(e);if(!t||!bx[t.part.kind])return null;let n=t.hit.point,s=a=>a.getWorldPosition(new X).distanceTo(n),o=[...this.home.keys()].filter(a=>this.parts.get(a.name).kind==="membrane").reduce((a,c)=>s(c)<s(a)?c:a);return{group:t.part.group,at:n,normal:new X(0,0,1).applyQuaternion(o.quaternion)}}pointOf(e){let t=e?.group.match(/^point (\d+)$/);return t?Number(t[1]):null}name(e){let t=this.under(e)?.part??null,n=t&&this.dragging&&I("movable").checked?bx[t.kind]:void 0;I("pointed-part").textContent=t?"\xB7 "+t.label.replaceAll("_"," ")+(n?`: ${n}`:""):"\xA0",this.sheet.style.cursor=n?"move":"grab",this.hover(this.pointOf(t))}key(e){let t={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,-.1],ArrowDown:[0,.1]},n=e.key==="+"?.9:e.key==="-"?1.1:1,s=t[e.key]??[0,0];if(n===1&&!s[0]&&!s[1])return;e.preventDefault();let r=this.camera.position.clone().sub(this.controls.target),o=r.length()*n,a=Math.acos(r.y/r.length())+s[1],c=Math.atan2(r.x,r.z)+s[0];this.turned=!0;let l=Math.min(Math.max(a,.02),3.1);this.camera.position.copy(this.controls.target).add(new X(o*Math.sin(l)*Math.sin(c),o*Math.cos(l),o*Math.sin(l)*Math.cos(c))),this.controls.update(),this.ask()}clear(){this.model.traverse(e=>{e instanceof ln&&(e.geometry.dispose(),e.material.dispose())}),this.model.clear(),this.marks=[]}};function Sx(i){return i.getContext("2d",{willReadFrequently:!0})}var Ep={ok:"\u2713",warn:"!",fail:"\u2717"},iu=class{constructor(e){this.light=e}light;now=null;take(e){this.now=e;let t=e.printing.findings,n=o=>t.filter(a=>a.verdict===o).length;I("print-verdict").textContent=`${e.verdict[0].toUpperCase()}${e.verdict.slice(1)}. ${e.printing.process.title}: ${n("fail")} failed, ${n("warn")} to look at, ${n("ok")} in order.`;let s=[...e.overlaps,...e.misfits,...e.mend?[e.mend]:[]];I("troubles").replaceChildren(...s.map(o=>$("li",{},o)));let r=t.filter(o=>o.verdict!=="ok").sort((o,a)=>+(o.verdict==="warn")-+(a.verdict==="warn"));I("findings").replaceChildren(...r.map(o=>this.row(o))),I("in-order").replaceChildren(...t.filter(o=>o.verdict==="ok").map(o=>this.row(o))),I("validity").replaceChildren(...e.validity.map(o=>$("li",{class:o.holds?"ok":"fail"},$("span",{class:"sign"},o.holds?Ep.ok:Ep.fail),$("span",{},`${o.assumption}: ${Ue(o.value)} ${bi(o.unit)}, ${o.relation} ${Ue(o.limit)} ${bi(o.unit)}; ${o.meaning}`))))}rows(){let e=["part","rule","value","relation","limit","unit","verdict"],t=this.now;return t?[e,...t.printing.findings.map(n=>[n.part,n.rule,n.value,n.relation,n.limit,n.unit,n.verdict]),...t.validity.map(n=>["model",n.assumption,n.value,n.relation,n.limit,n.unit,n.holds?"ok":"fail"])]:[e]}row(e){let t=`${e.part}: ${e.rule} ${Ue(e.value,3)} ${bi(e.unit)}, ${e.relation} ${Ue(e.limit,3)} ${bi(e.unit)}`,n=Vt(t,()=>this.light(e.part,e.place),{class:"finding",title:e.reason});return $("li",{class:e.verdict},$("span",{class:"sign",title:e.verdict},Ep[e.verdict]),n)}};var su=class{constructor(e){this.colouring=e}colouring;shown=null;show(e){this.shown=e;let t=I("point-card");if(t.hidden=e===null,e===null)return;let n=$("span",{class:"swatch"});n.style.background=this.colouring.of(e),t.dataset.point=String(e),t.replaceChildren($("strong",{},n,`point ${e}`),$("dl",{},...this.colouring.figures(e).flatMap(([s,r])=>[$("dt",{},s),$("dd",{},r)])))}redraw(){this.show(this.shown)}};var Cl={number:{title:"point",unit:"",value:i=>i.number},as_built:{title:"as-built accuracy",unit:"%",value:(i,e)=>e?100*e[i.number-1]:null,low:90,high:100},named:{title:"accuracy as designed",unit:"%",value:i=>100*i.named,low:90,high:100},loudest:{title:"level at 100 Hz, loudest microphone",unit:"dB",value:i=>i.loudest},force:{title:"smallest detectable force",unit:"nN",value:i=>1e9*i.force},coverage:{title:"coverage of its area",unit:"%",value:i=>100*i.coverage,high:100}},ru=class{constructor(e){this.changed=e;let t=I("colour-by");t.replaceChildren(...Object.entries(Cl).map(([n,{title:s}])=>$("option",{value:n},s))),t.addEventListener("change",()=>{this.chosen=t.value,this.measure(),this.changed()})}changed;points=[];built=null;count=0;chosen="number";low=1;high=1;get wantsBuilt(){return this.chosen==="as_built"}get isByFigure(){return this.chosen!=="number"}take(e){this.points=e.points,this.count=e.points.length,this.measure()}asBuilt(e){this.built=e.per_point,this.measure()}size(e){e!==this.count&&(this.count=e,this.points=[],this.built=null,this.measure())}figures(e){let t=this.points.find(s=>s.number===e);return t?[...Object.entries(Cl).filter(([s])=>s!=="number").map(([,s])=>{let r=s.value(t,this.built);return[s.title,r===null?"":`${Ue(r,3)} ${s.unit}`]}),["hardest to tell from",`point ${t.nearest}`]].filter(([,s])=>s):[]}of(e){let t=Cl[this.chosen],n=this.points.find(r=>r.number===e),s=this.chosen==="number"?e<=this.count?e:null:n?t.value(n,this.built):null;return s===null?"rgb(128,128,128)":Al((s-this.low)/(this.high-this.low||1))}measure(){let{value:e,low:t,high:n}=Cl[this.chosen];if(this.chosen==="number")[this.low,this.high]=[1,Math.max(this.count,1)];else{let s=this.points.map(r=>e(r,this.built)).filter(r=>r!==null);this.low=Math.min(...s,t??1/0),this.high=Math.max(...s,n??-1/0)}this.legend()}legend(){let{title:e,unit:t}=Cl[this.chosen],n=I("legend");n.hidden=!Number.isFinite(this.low)||this.count===0;let s=Array.from({length:9},(a,c)=>Al(c/8)).join(","),r=$("span",{class:"bar"}),o=a=>`${Ue(a,3)}${t?` ${t}`:""}`;r.style.background=`linear-gradient(to right, ${s})`,n.replaceChildren($("span",{},e),$("span",{class:"ends"},$("span",{id:"legend-low"},o(this.low)),r,$("span",{id:"legend-high"},o(this.high))))}};var ou=class{compared=[];differences=[];take(e){let t=e.pinned!==null;if(I("compare-empty").hidden=t,I("compare-tables").hidden=!t,!t){this.compared=[],I("compared-figures").replaceChildren();return}I("pinned-name").textContent=e.pinned,this.differences=e.differences??[];let n=this.differences.map(s=>$("tr",{},$("th",{scope:"row"},s.name),$("td",{},Ap(s.there,s.unit)),$("td",{},Ap(s.here,s.unit))));I("differences").replaceChildren(...n.length?n:[$("tr",{},$("td",{colspan:"3"},"no field differs"))])}pinned(e){return this.compared.find(t=>t.name===e)?.there??void 0}rows(){return[["field or figure","unit","pinned","now"],...[...this.differences,...this.compared].map(e=>[e.name,e.unit,Mx(e.there),Mx(e.here)])]}figures(e){this.compared=e,I("compared-figures").replaceChildren(...e.map(t=>$("tr",{title:t.definition,"data-figure":t.name},$("th",{scope:"row"},t.title),$("td",{},t.texts[0]||"\u2013"),$("td",{class:t.better},t.texts[1]||"\u2013"),$("td",{class:t.better},t.better))))}};function Mx(i){return typeof i=="number"?i:Ap(i,"")}function Ap(i,e){return i==null?"\u2013":typeof i=="number"?`${Ue(i,6)}${e?` ${bi(e)}`:""}`:Array.isArray(i)?i.join(", "):String(i)}var mE="uplot",gE="u-hz",xE="u-vt",_E="u-title",vE="u-wrap",yE="u-under",bE="u-over",SE="u-axis",Zr="u-off",ME="u-select",wE="u-cursor-x",TE="u-cursor-y",EE="u-cursor-pt",AE="u-legend",RE="u-live",CE="u-inline",PE="u-series",IE="u-marker",wx="u-label",LE="u-value",Il="width",Ll="height";var Tx="bottom",sa="left",Rp="right",Xp="#000",Ex=Xp+"0",Cp="mousemove",Ax="mousedown",Pp="mouseup",Rx="mouseenter",Cx="mouseleave",Px="dblclick",NE="resize",DE="scroll",Ix="change",uu="dppxchange",qp="--",ua=typeof window<"u",Op=ua?document:null,oa=ua?window:null,OE=ua?navigator:null,Rt,au;function Up(){let i=devicePixelRatio;Rt!=i&&(Rt=i,au&&kp(Ix,au,Up),au=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Jr(Ix,au,Up),oa.dispatchEvent(new CustomEvent(uu)))}function Mi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Fp(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function Qi(i,e,t,n){let s=Op.createElement(i);return e!=null&&Mi(s,e),t?.insertBefore(s,n),s}function ki(i,e){return Qi("div",i,e)}var Lx=new WeakMap;function Ms(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Lx.get(i);r!=o&&(i.style.transform=r,Lx.set(i,r),e<0||t<0||e>n||t>s?Mi(i,Zr):Fp(i,Zr))}var Nx=new WeakMap;function Dx(i,e,t){let n=e+t,s=Nx.get(i);n!=s&&(Nx.set(i,n),i.style.background=e,i.style.borderColor=t)}var Ox=new WeakMap;function Ux(i,e,t,n){let s=e+""+t,r=Ox.get(i);s!=r&&(Ox.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var $p={passive:!0},UE={...$p,capture:!0};function Jr(i,e,t,n){e.addEventListener(i,t,n?UE:$p)}function kp(i,e,t,n){e.removeEventListener(i,t,$p)}ua&&Up();function es(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:wi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function h_(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var u_=i=>i!=null,d_=i=>i!=null&&i>0,pu=h_(u_),FE=h_(d_);function kE(i,e,t,n=0,s=!1){let r=s?FE:pu,o=s?d_:u_;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let h=i[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Bt,c??-Bt]}function mu(i,e,t,n){let s=Bx(i),r=Bx(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ys:f_,a=s==1?wi:Bi,c=r==1?Bi:wi,l=a(o(En(i))),h=c(o(En(e))),u=aa(t,l),d=aa(t,h);return t==10&&(l<0&&(u=zt(u,-l)),h<0&&(d=zt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=x_(i,u),e=gu(e,d)),[i,e]}function Yp(i,e,t,n){let s=mu(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Kp=.1,Fx={mode:3,pad:Kp},Dl={pad:0,soft:null,mode:0},BE={min:Dl,max:Dl};function du(i,e,t,n){return xu(t)?kx(i,e,t):(Dl.pad=t,Dl.soft=n?0:null,Dl.mode=n?3:0,kx(i,e,BE))}function Tt(i,e){return i??e}function zE(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function kx(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-Bt),c=Tt(s.hard,Bt),l=Tt(n.soft,Bt),h=Tt(s.soft,-Bt),u=Tt(n.mode,0),d=Tt(s.mode,0),f=e-i,p=Ys(f),v=ri(En(i),En(e)),g=Ys(v),m=En(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&l!=Bt&&(r=0),d==2&&h!=-Bt&&(o=0)));let y=f||v||1e3,M=Ys(y),b=aa(10,wi(M)),R=y*(f==0?i==0?.1:1:r),A=zt(x_(i-R,b/10),24),x=i>=l&&(u==1||u==3&&A<=l||u==2&&A>=l)?l:Bt,E=ri(a,A<x&&i>=x?x:ts(x,A)),k=y*(f==0?e==0?.1:1:o),D=zt(gu(e+k,b/10),24),L=e<=h&&(d==1||d==3&&D>=h||d==2&&D<=h)?h:-Bt,G=ts(c,D>L&&e<=L?L:ri(L,D));return E==G&&E==0&&(G=100),[E,G]}var HE=new Intl.NumberFormat(ua?OE.language:"en-US"),jp=i=>HE.format(i),Ti=Math,hu=Ti.PI,En=Ti.abs,wi=Ti.floor,Tn=Ti.round,Bi=Ti.ceil,ts=Ti.min,ri=Ti.max,aa=Ti.pow,Bx=Ti.sign,Ys=Ti.log10,f_=Ti.log2,VE=(i,e=1)=>Ti.sinh(i)*e,Ip=(i,e=1)=>Ti.asinh(i/e),Bt=1/0;function zx(i){return(Ys((i^i>>31)-(i>>31))|0)+1}function Bp(i,e,t){return ts(ri(i,e),t)}function p_(i){return typeof i=="function"}function St(i){return p_(i)?i:()=>i}var GE=()=>{},m_=i=>i,g_=(i,e)=>e,WE=i=>null,Hx=i=>!0,Vx=(i,e)=>i==e,XE=/\.\d*?(?=9{6,}|0{6,})/gm,Qr=i=>{if(v_(i)||yr.has(i))return i;let e=`${i}`,t=e.match(XE);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Qr(s)}e${r}`}return zt(i,n)};function Kr(i,e){return Qr(zt(Qr(i/e))*e)}function gu(i,e){return Qr(Bi(Qr(i/e))*e)}function x_(i,e){return Qr(wi(Qr(i/e))*e)}function zt(i,e=0){if(v_(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Tn(n)/t}var yr=new Map;function __(i){return((""+i).split(".")[1]||"").length}function Ul(i,e,t,n){let s=[],r=n.map(__);for(let o=e;o<t;o++){let a=En(o),c=zt(aa(i,o),a);for(let l=0;l<n.length;l++){let h=i==10?+`${n[l]}e${o}`:n[l]*c,u=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=i==10?h:zt(h,u);s.push(d),yr.set(d,u)}}return s}var Ol={},Zp=[],la=[null,null],vr=Array.isArray,v_=Number.isInteger,qE=i=>i===void 0;function Gx(i){return typeof i=="string"}function xu(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function $E(i){return i!=null&&typeof i=="object"}var YE=Object.getPrototypeOf(Uint8Array),y_="__proto__";function ca(i,e=xu){let t;if(vr(i)){let n=i.find(s=>s!=null);if(vr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ca(i[s],e)}else t=i.slice()}else if(i instanceof YE)t=i.slice();else if(e(i)){t={};for(let n in i)n!=y_&&(t[n]=ca(i[n],e))}else t=i;return t}function gn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=y_&&(xu(i[s])?gn(i[s],ca(n[s])):i[s]=ca(n[s]))}return i}var KE=0,jE=1,ZE=2;function JE(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function QE(i,e){if(n1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return i1(o[0])||(o=t1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let h=0;h<l;h++)t.add(c[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],u=Array(s).fill(void 0),d=e?e[o][l]:jE,f=[];for(let p=0;p<h.length;p++){let v=h[p],g=r.get(c[p]);v===null?d!=KE&&(u[g]=v,d==ZE&&f.push(g)):u[g]=v}JE(u,f,s),n.push(u)}}return n}var e1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function t1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function n1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function i1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ri(1,wi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var b_=["January","February","March","April","May","June","July","August","September","October","November","December"],S_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function M_(i){return i.slice(0,3)}var s1=S_.map(M_),r1=b_.map(M_),o1={MMMM:b_,MMM:r1,WWWW:S_,WWW:s1};function Pl(i){return(i<10?"0":"")+i}function a1(i){return(i<10?"00":i<100?"0":"")+i}var l1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Pl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Pl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Pl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Pl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Pl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>a1(i.getMilliseconds())};function Jp(i,e){e=e||o1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?l1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var c1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function h1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==c1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var w_=i=>i%1==0,fu=[1,2,2.5,5],u1=Ul(10,-32,0,fu),T_=Ul(10,0,32,fu),d1=T_.filter(w_),jr=u1.concat(T_),Qp=`
`,E_="{YYYY}",Wx=Qp+E_,A_="{M}/{D}",Nl=Qp+A_,lu=Nl+"/{YY}",R_="{aa}",f1="{h}:{mm}",ra=f1+R_,Xx=Qp+ra,qx=":{ss}",Pt=null;function C_(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?Ul(10,0,3,fu).filter(w_):Ul(10,-3,0,fu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,E_,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Wx,Pt,Pt,Pt,Pt,Pt,1],[s,A_,Wx,Pt,Pt,Pt,Pt,Pt,1],[n,"{h}"+R_,lu,Pt,Nl,Pt,Pt,Pt,1],[t,ra,lu,Pt,Nl,Pt,Pt,Pt,1],[e,qx,lu+" "+ra,Pt,Nl+" "+ra,Pt,Xx,Pt,1],[i,qx+".{fff}",lu+" "+ra,Pt,Nl+" "+ra,Pt,Xx,Pt,1]];function h(u){return(d,f,p,v,g,m)=>{let y=[],M=g>=o,b=g>=r&&g<o,R=u(p),A=zt(R*i,3),x=Lp(R.getFullYear(),M?0:R.getMonth(),b||M?1:R.getDate()),E=zt(x*i,3);if(b||M){let k=b?g/r:0,D=M?g/o:0,L=A==E?A:zt(Lp(x.getFullYear()+D,x.getMonth()+k,1)*i,3),G=new Date(Tn(L/i)),W=G.getFullYear(),O=G.getMonth();for(let H=0;L<=v;H++){let Y=Lp(W+D*H,O+k*H,1),B=Y-u(zt(Y*i,3));L=zt((+Y+B)*i,3),L<=v&&y.push(L)}}else{let k=g>=s?s:g,D=wi(p)-wi(A),L=E+D+gu(A-E,k);y.push(L);let G=u(L),W=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,O=g/n,H=d.axes[f]._space,Y=m/H;for(;L=zt(L+g,i==1?0:3),!(L>v);)if(O>1){let B=wi(zt(W+O,6))%24,ee=u(L).getHours()-B;ee>1&&(ee=-1),L-=ee*n,W=(W+O)%24;let se=y[y.length-1];zt((L-se)/g,3)*Y>=.7&&y.push(L)}else y.push(L)}return y}}return[c,l,h]}var[p1,m1,g1]=C_(1),[x1,_1,v1]=C_(.001);Ul(2,-53,53,[1]);function $x(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Yx(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],c,l,h,u,d,f;return n.map(p=>{let v=i(p),g=v.getFullYear(),m=v.getMonth(),y=v.getDate(),M=v.getHours(),b=v.getMinutes(),R=v.getSeconds(),A=g!=c&&a[2]||m!=l&&a[3]||y!=h&&a[4]||M!=u&&a[5]||b!=d&&a[6]||R!=f&&a[7]||a[1];return c=g,l=m,h=y,u=M,d=b,f=R,A(v)})}}function y1(i,e){let t=Jp(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Lp(i,e,t){return new Date(i,e,t)}function Kx(i,e){return e(i)}var b1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function jx(i,e){return(t,n,s,r)=>r==null?qp:e(i(n))}function S1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function M1(i,e){return i.series[e].fill(i,e)}var w1={show:!0,live:!0,isolate:!1,mount:GE,markers:{show:!0,width:2,stroke:S1,fill:M1,dash:"solid"},idx:null,idxs:null,values:[]};function T1(i,e){let t=i.cursor.points,n=ki(),s=t.size(i,e);$t(n,Il,s),$t(n,Ll,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function E1(i,e){let t=i.series[e].points;return t._fill||t._stroke}function A1(i,e){let t=i.series[e].points;return t._stroke||t._fill}function R1(i,e){return i.series[e].points.size}var Np=[0,0];function C1(i,e,t){return Np[0]=e,Np[1]=t,Np}function cu(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Dp(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var P1={show:!0,x:!0,y:!0,lock:!1,move:C1,points:{one:!1,show:T1,size:R1,width:0,stroke:A1,fill:E1},bind:{mousedown:cu,mouseup:cu,click:cu,dblclick:cu,mousemove:Dp,mouseleave:Dp,mouseenter:Dp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},P_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},em=gn({},P_,{filter:g_}),I_=gn({},em,{size:10}),L_=gn({},P_,{show:!1}),tm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',N_="bold "+tm,D_=1.5,Zx={show:!0,scale:"x",stroke:Xp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N_,side:2,grid:em,ticks:I_,border:L_,font:tm,lineGap:D_,rotate:0},I1="Value",L1="Time",Jx={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function N1(i,e,t,n,s){return e.map(r=>r==null?"":jp(r))}function D1(i,e,t,n,s,r,o){let a=[],c=yr.get(s)||0;t=o?t:zt(gu(t,s),c);for(let l=t;l<=n;l=zt(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function zp(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?Ys:f_,h=wi(l(t));s=aa(c,h),c==10&&(s=jr[es(s,jr)]);let u=t,d=s*c;c==10&&(d=jr[es(d,jr)]);do a.push(u),u=u+s,c==10&&!yr.has(u)&&(u=zt(u,yr.get(s))),u>=d&&(s=u,d=s*c,c==10&&(d=jr[es(d,jr)]));while(u<=n);return a}function O1(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?zp(i,e,ri(c,t),n,s):[c],h=n>=0&&t<=0?[0]:[];return(t<-c?zp(i,e,ri(c,-n),-t,s):[c]).reverse().map(d=>-d).concat(h,l)}var O_=/./,U1=/[12357]/,F1=/[125]/,Qx=/1/,Hp=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function k1(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,h=c(10,o),u=c(9,o)-h>=l?O_:c(7,o)-h>=l?U1:c(5,o)-h>=l?F1:Qx;if(u==Qx){let d=En(c(1,o)-h);if(d<l)return Hp(e.slice().reverse(),a.distr,u,Bi(l/d)).reverse()}return Hp(e,a.distr,u,1)}function B1(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=En(c(1,o)-c(2,o));return l<a?Hp(e.slice().reverse(),3,O_,Bi(a/l)).reverse():e}function z1(i,e,t,n){return n==null?qp:e==null?"":jp(e)}var e_={show:!0,scale:"y",stroke:Xp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N_,side:3,grid:em,ticks:I_,border:L_,font:tm,lineGap:D_,rotate:0};function H1(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function V1(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=En(o-r),c=i.series[e],l=a/(c.points.space*Rt);return n[1]-n[0]<=l}var t_={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},U_=(i,e,t,n,s)=>s,n_={show:!0,auto:!0,sorted:0,gaps:U_,alpha:1,facets:[gn({},t_,{scale:"x"}),gn({},t_,{scale:"y"})]},i_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:U_,alpha:1,points:{show:V1,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function G1(i,e,t,n,s){return t/10}var F_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},W1=gn({},F_,{time:!1,ori:1}),s_={};function k_(i,e){let t=s_[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,c,l)}},i!=null&&(s_[i]=t)),t}var ha=1,Vp=2;function eo(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,v=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,c,l,h,u,g,m,d,f,p,v,vu,da,bu,z_,V_):t(s,c,l,h,u,m,g,f,d,v,p,yu,fa,sm,H_,G_)}function nm(i,e){let t=0,n=0,s=Tt(i.bands,Zp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function X1(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Ks(i,e,t,n,s,r){return eo(i,e,(o,a,c,l,h,u,d,f,p,v,g)=>{let m=o.pxRound,y=l.dir*(l.ori==0?1:-1),M=l.ori==0?da:fa,b,R;y==1?(b=t,R=n):(b=n,R=t);let A=m(u(a[b],l,v,f)),x=m(d(c[b],h,g,p)),E=m(u(a[R],l,v,f)),k=m(d(r==1?h.max:h.min,h,g,p)),D=new Path2D(s);return M(D,E,k),M(D,A,k),M(D,A,x),D})}function _u(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?bu:sm,c=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,n,f,n+r),c=d[1]}}let l=t+s-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function q1(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function im(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let u=l,d=l;if(s==1)for(;++l<=n&&e[l]===null;)d=l;else for(;--l>=t&&e[l]===null;)d=l;let f=r(i[u]),p=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<c?r(i[v]):f;let m=d+s;p=o>=0&&m>=0&&m<c?r(i[m]):p,p>=f&&a.push([f,p])}return a}function r_(i){return i==0?m_:i==1?Tn:e=>Kr(e,i)}function B_(i){let e=i==0?vu:yu,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(s,r,o,a,c):(l=ts(l,a/2,c/2),h=ts(h,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,h),t(s,r,o+c,r,o,h),t(s,r,o,r+a,o,l),s.closePath())}}var vu=(i,e,t)=>{i.moveTo(e,t)},yu=(i,e,t)=>{i.moveTo(t,e)},da=(i,e,t)=>{i.lineTo(e,t)},fa=(i,e,t)=>{i.lineTo(t,e)},bu=B_(0),sm=B_(1),z_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},H_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},V_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},G_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function W_(i){return(e,t,n,s,r)=>eo(e,t,(o,a,c,l,h,u,d,f,p,v,g)=>{let{pxRound:m,points:y}=o,M,b;l.ori==0?(M=vu,b=z_):(M=yu,b=H_);let R=zt(y.width*Rt,3),A=(y.size-y.width)/2*Rt,x=zt(A*2,3),E=new Path2D,k=new Path2D,{left:D,top:L,width:G,height:W}=e.bbox;bu(k,D-x,L-x,G+x*2,W+x*2);let O=H=>{if(c[H]!=null){let Y=m(u(a[H],l,v,f)),B=m(d(c[H],h,g,p));M(E,Y+A,B),b(E,Y,B,A,0,hu*2)}};if(r)r.forEach(O);else for(let H=n;H<=s;H++)O(H);return{stroke:R>0?E:null,fill:E,clip:k,flags:ha|Vp}})}function X_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var $1=X_(da),Y1=X_(fa);function q_(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>eo(t,n,(o,a,c,l,h,u,d,f,p,v,g)=>{[s,r]=pu(c,s,r);let m=o.pxRound,y=W=>m(u(W,l,v,f)),M=W=>m(d(W,h,g,p)),b,R;l.ori==0?(b=da,R=$1):(b=fa,R=Y1);let A=l.dir*(l.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ha},E=x.stroke,k=!1;if(r-s>=v*4){let W=de=>t.posToVal(de,l.key,!0),O=null,H=null,Y,B,ce,Z=y(a[A==1?s:r]),ee=y(a[s]),se=y(a[r]),fe=W(A==1?ee+1:se-1);for(let de=A==1?s:r;de>=s&&de<=r;de+=A){let te=a[de],ve=(A==1?te<fe:te>fe)?Z:y(te),Re=c[de];ve==Z?Re!=null?(B=Re,O==null?(b(E,ve,M(B)),Y=O=H=B):B<O?O=B:B>H&&(H=B)):Re===null&&(k=!0):(O!=null&&R(E,Z,M(O),M(H),M(Y),M(B)),Re!=null?(B=Re,b(E,ve,M(B)),O=H=Y=B):(O=H=null,Re===null&&(k=!0)),Z=ve,fe=W(Z+A))}O!=null&&O!=H&&ce!=Z&&R(E,Z,M(O),M(H),M(Y),M(B))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let O=c[W];O===null?k=!0:O!=null&&b(E,y(a[W]),M(O))}let[L,G]=nm(t,n);if(o.fill!=null||L!=0){let W=x.fill=new Path2D(E),O=o.fillTo(t,n,o.min,o.max,L),H=M(O),Y=y(a[s]),B=y(a[r]);A==-1&&([B,Y]=[Y,B]),b(W,B,H),b(W,Y,H)}if(!o.spanGaps){let W=[];k&&W.push(...im(a,c,s,r,A,y,e)),x.gaps=W=o.gaps(t,n,s,r,W),x.clip=_u(W,l.ori,f,p,v,g)}return G!=0&&(x.band=G==2?[Ks(t,n,s,r,E,-1),Ks(t,n,s,r,E,1)]:Ks(t,n,s,r,E,G)),x})}function K1(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,c)=>eo(r,o,(l,h,u,d,f,p,v,g,m,y,M)=>{[a,c]=pu(u,a,c);let b=l.pxRound,{left:R,width:A}=r.bbox,x=ee=>b(p(ee,d,y,g)),E=ee=>b(v(ee,f,M,m)),k=d.ori==0?da:fa,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ha},L=D.stroke,G=d.dir*(d.ori==0?1:-1),W=E(u[G==1?a:c]),O=x(h[G==1?a:c]),H=O,Y=O;s&&e==-1&&(Y=R,k(L,Y,W)),k(L,O,W);for(let ee=G==1?a:c;ee>=a&&ee<=c;ee+=G){let se=u[ee];if(se==null)continue;let fe=x(h[ee]),de=E(se);e==1?k(L,fe,W):k(L,H,de),k(L,fe,de),W=de,H=fe}let B=H;s&&e==1&&(B=R+A,k(L,B,W));let[ce,Z]=nm(r,o);if(l.fill!=null||ce!=0){let ee=D.fill=new Path2D(L),se=l.fillTo(r,o,l.min,l.max,ce),fe=E(se);k(ee,B,fe),k(ee,Y,fe)}if(!l.spanGaps){let ee=[];ee.push(...im(h,u,a,c,G,x,n));let se=l.width*Rt/2,fe=t||e==1?se:-se,de=t||e==-1?-se:se;ee.forEach(te=>{te[0]+=fe,te[1]+=de}),D.gaps=ee=l.gaps(r,o,a,c,ee),D.clip=_u(ee,d.ori,g,m,y,M)}return Z!=0&&(D.band=Z==2?[Ks(r,o,a,c,L,-1),Ks(r,o,a,c,L,1)]:Ks(r,o,a,c,L,Z)),D})}function o_(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let h=En(i[c]-i[a]);h<l&&(l=h,o=En(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function j1(i){i=i||Ol;let e=Tt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=St(s),o=1-e[0],a=Tt(e[1],Bt),c=Tt(e[2],1),l=Tt(i.disp,Ol),h=Tt(i.each,f=>{}),{fill:u,stroke:d}=l;return(f,p,v,g)=>eo(f,p,(m,y,M,b,R,A,x,E,k,D,L)=>{let G=m.pxRound,W=t,O=n*Rt,H=a*Rt,Y=c*Rt,B,ce;b.ori==0?[B,ce]=r(f,p):[ce,B]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),ee=b.ori==0?bu:sm,se=b.ori==0?h:(Pe,Je,lt,we,Ft,Ge,Ze)=>{h(Pe,Je,lt,Ft,we,Ze,Ge)},fe=Tt(f.bands,Zp).find(Pe=>Pe.series[0]==p),de=fe!=null?fe.dir:0,te=m.fillTo(f,p,m.min,m.max,de),ge=G(x(te,R,L,k)),ve,Re,Me,$e=D,at=G(m.width*Rt),We=!1,pt=null,ut=null,rt=null,Yt=null;u!=null&&(at==0||d!=null)&&(We=!0,pt=u.values(f,p,v,g),ut=new Map,new Set(pt).forEach(Pe=>{Pe!=null&&ut.set(Pe,new Path2D)}),at>0&&(rt=d.values(f,p,v,g),Yt=new Map,new Set(rt).forEach(Pe=>{Pe!=null&&Yt.set(Pe,new Path2D)})));let{x0:Ht,size:cn}=l;if(Ht!=null&&cn!=null){W=1,y=Ht.values(f,p,v,g),Ht.unit==2&&(y=y.map(lt=>f.posToVal(E+lt*D,b.key,!0)));let Pe=cn.values(f,p,v,g);cn.unit==2?Re=Pe[0]*D:Re=A(Pe[0],b,D,E)-A(0,b,D,E),$e=o_(y,M,A,b,D,E,$e),Me=$e-Re+O}else $e=o_(y,M,A,b,D,E,$e),Me=$e*o+O,Re=$e-Me;Me<1&&(Me=0),at>=Re/2&&(at=0),Me<5&&(G=m_);let Ot=Me>0,Rn=$e-Me-(Ot?at:0);Re=G(Bp(Rn,Y,H)),ve=(W==0?Re/2:W==Z?0:Re)-W*Z*((W==0?O/2:0)+(Ot?at/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=We?null:new Path2D,Qt=null;if(fe!=null)Qt=f.data[fe.series[1]];else{let{y0:Pe,y1:Je}=l;Pe!=null&&Je!=null&&(M=Je.values(f,p,v,g),Qt=Pe.values(f,p,v,g))}let hn=B*Re,F=ce*Re;for(let Pe=Z==1?v:g;Pe>=v&&Pe<=g;Pe+=Z){let Je=M[Pe];if(Je==null)continue;if(Qt!=null){let q=Qt[Pe]??0;if(Je-q==0)continue;ge=x(q,R,L,k)}let lt=b.distr!=2||l!=null?y[Pe]:Pe,we=A(lt,b,D,E),Ft=x(Tt(Je,te),R,L,k),Ge=G(we-ve),Ze=G(ri(Ft,ge)),C=G(ts(Ft,ge)),S=Ze-C;if(Je!=null){let q=Je<0?F:hn,ue=Je<0?hn:F;We?(at>0&&rt[Pe]!=null&&ee(Yt.get(rt[Pe]),Ge,C+wi(at/2),Re,ri(0,S-at),q,ue),pt[Pe]!=null&&ee(ut.get(pt[Pe]),Ge,C+wi(at/2),Re,ri(0,S-at),q,ue)):ee(xn,Ge,C+wi(at/2),Re,ri(0,S-at),q,ue),se(f,p,Pe,Ge-at/2,C,Re+at,S)}}return at>0?Mt.stroke=We?Yt:xn:We||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=We?ut:xn,Mt})}function Z1(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>eo(n,s,(a,c,l,h,u,d,f,p,v,g,m)=>{[r,o]=pu(l,r,o);let y=a.pxRound,M=B=>y(d(B,h,g,p)),b=B=>y(f(B,u,m,v)),R,A,x;h.ori==0?(R=vu,x=da,A=V_):(R=yu,x=fa,A=G_);let E=h.dir*(h.ori==0?1:-1),k=M(c[E==1?r:o]),D=k,L=[],G=[];for(let B=E==1?r:o;B>=r&&B<=o;B+=E)if(l[B]!=null){let Z=c[B],ee=M(Z);L.push(D=ee),G.push(b(l[B]))}let W={stroke:i(L,G,R,x,A,y),fill:null,clip:null,band:null,gaps:null,flags:ha},O=W.stroke,[H,Y]=nm(n,s);if(a.fill!=null||H!=0){let B=W.fill=new Path2D(O),ce=a.fillTo(n,s,a.min,a.max,H),Z=b(ce);x(B,D,Z),x(B,k,Z)}if(!a.spanGaps){let B=[];B.push(...im(c,l,r,o,E,M,t)),W.gaps=B=a.gaps(n,s,r,o,B),W.clip=_u(B,h.ori,p,v,g,m)}return Y!=0&&(W.band=Y==2?[Ks(n,s,r,o,O,-1),Ks(n,s,r,o,O,1)]:Ks(n,s,r,o,O,Y)),W})}function J1(i){return Z1(Q1,i)}function Q1(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],l[d]=h[d]/u[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/l[d-1]+(u[d]+2*u[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+c[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-c[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Gp=new Set;function a_(){for(let i of Gp)i.syncRect(!0)}ua&&(Jr(NE,oa,a_),Jr(DE,oa,a_,!0),Jr(uu,oa,()=>{Hn.pxRatio=Rt}));var eA=q_(),tA=W_();function l_(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Wp(r,o,e,t))}function nA(i,e){return i.map((t,n)=>n==0?{}:gn({},e,t))}function Wp(i,e,t,n){return gn({},e==0?t:n,i)}function $_(i,e,t){return e==null?la:[e,t]}var iA=$_;function sA(i,e,t){return e==null?la:du(e,t,Kp,!0)}function Y_(i,e,t,n){return e==null?la:mu(e,t,i.scales[n].log,!1)}var rA=Y_;function K_(i,e,t,n){return e==null?la:Yp(e,t,i.scales[n].log,!1)}var oA=K_;function aA(i,e,t,n,s){let r=ri(zx(i),zx(e)),o=e-i,a=es(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?yr.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function c_(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Tn((t=+s)*Rt))+"px"),[i,e,t]}function lA(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Hn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(_,w,P,N){let V=w.valToPct(_);return N+P*(w.dir==-1?1-V:V)}function o(_,w,P,N){let V=w.valToPct(_);return N+P*(w.dir==-1?V:1-V)}function a(_,w,P,N){return w.ori==0?r(_,w,P,N):o(_,w,P,N)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=ki(mE);if(i.id!=null&&(l.id=i.id),Mi(l,i.class),i.title){let _=ki(_E,l);_.textContent=i.title}let h=Qi("canvas"),u=n.ctx=h.getContext("2d"),d=ki(vE,l);Jr("click",d,_=>{_.target===p&&(Wt!=lo||Kt!=co)&&kn.click(n,_)},!0);let f=n.under=ki(yE,d);d.appendChild(h);let p=n.over=ki(bE,d);i=ca(i);let v=+Tt(i.pxAlign,1),g=r_(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?l_(i.series||[],Jx,i_,!1):nA(i.series||[null],n_),M=n.axes=l_(i.axes||[],Zx,e_,!0),b=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=St(_.fill||null),_.dir=Tt(_.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,x={axes:Rs,series:vt},E=(i.drawOrder||["axes","series"]).map(_=>x[_]);function k(_){let w=_.distr==3?P=>Ys(P>0?P:_.clamp(n,P,_.min,_.max,_.key)):_.distr==4?P=>Ip(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=w(P),{_min:V,_max:J}=_,le=J-V;return(N-V)/le}}function D(_){let w=b[_];if(w==null){let P=(i.scales||Ol)[_]||Ol;if(P.from!=null){D(P.from);let N=gn({},b[P.from],P,{key:_});N.valToPct=k(N),b[_]=N}else{w=b[_]=gn({},_==A?F_:W1,P),w.key=_;let N=w.time,V=w.range,J=vr(V);if((_!=A||s==2&&!N)&&(J&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Fx:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Fx:{mode:1,hard:V[1],soft:V[1]}},J=!1),!J&&xu(V))){let le=V;V=(pe,be,Oe)=>be==null?la:du(be,Oe,le)}w.range=St(V||(N?iA:_==A?w.distr==3?rA:w.distr==4?oA:$_:w.distr==3?Y_:w.distr==4?K_:sA)),w.auto=St(J?!1:w.auto),w.clamp=St(w.clamp||G1),w._min=w._max=null,w.valToPct=k(w)}}}D("x"),D("y"),s==1&&y.forEach(_=>{D(_.scale)}),M.forEach(_=>{D(_.scale)});for(let _ in i.scales)D(_);let L=b[A],G=L.distr,W,O;L.ori==0?(Mi(l,gE),W=r,O=o):(Mi(l,xE),W=o,O=r);let H={};for(let _ in b){let w=b[_];(w.min!=null||w.max!=null)&&(H[_]={min:w.min,max:w.max},w.min=w.max=null)}let Y=i.tzDate||(_=>new Date(Tn(_/m))),B=i.fmtDate||Jp,ce=m==1?g1(Y):v1(Y),Z=Yx(Y,$x(m==1?m1:_1,B)),ee=jx(Y,Kx(b1,B)),se=[],fe=n.legend=gn({},w1,i.legend),de=n.cursor=gn({},P1,{drag:{y:s==2}},i.cursor),te=fe.show,ge=de.show,ve=fe.markers;fe.idxs=se,ve.width=St(ve.width),ve.dash=St(ve.dash),ve.stroke=St(ve.stroke),ve.fill=St(ve.fill);let Re,Me,$e,at=[],We=[],pt,ut=!1,rt={};if(fe.live){let _=y[1]?y[1].values:null;ut=_!=null,pt=ut?_(n,1,0):{_:0};for(let w in pt)rt[w]=qp}if(te)if(Re=Qi("table",AE,l),$e=Qi("tbody",null,Re),fe.mount(n,Re),ut){Me=Qi("thead",null,Re,$e);let _=Qi("tr",null,Me);Qi("th",null,_);for(var Yt in pt)Qi("th",wx,_).textContent=Yt}else Mi(Re,CE),fe.live&&Mi(Re,RE);let Ht={show:!0},cn={show:!1};function Ot(_,w){if(w==0&&(ut||!fe.live||s==2))return la;let P=[],N=Qi("tr",PE,$e,$e.childNodes[w]);Mi(N,_.class),_.show||Mi(N,Zr);let V=Qi("th",null,N);if(ve.show){let pe=ki(IE,V);if(w>0){let be=ve.width(n,w);be&&(pe.style.border=be+"px "+ve.dash(n,w)+" "+ve.stroke(n,w)),pe.style.background=ve.fill(n,w)}}let J=ki(wx,V);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,w>0&&(ve.show||(J.style.color=_.width>0?ve.stroke(n,w):ve.fill(n,w)),Mt("click",V,pe=>{if(de._lock)return;et(pe);let be=y.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Oe=y.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);y.forEach((Fe,Be)=>{Be>0&&as(Be,Oe?Be==be?Ht:cn:Ht,!0,pn.setSeries)})}else as(be,{show:!_.show},!0,pn.setSeries)},!1),tt&&Mt(Rx,V,pe=>{de._lock||(et(pe),as(y.indexOf(_),uo,!0,pn.setSeries))},!1));for(var le in pt){let pe=Qi("td",LE,N);pe.textContent="--",P.push(pe)}return[N,P]}let Rn=new Map;function Mt(_,w,P,N=!0){let V=Rn.get(w)||{},J=de.bind[_](n,w,P,N);J&&(Jr(_,w,V[_]=J),Rn.set(w,V))}function xn(_,w,P){let N=Rn.get(w)||{};for(let V in N)(_==null||V==_)&&(kp(V,w,N[V]),delete N[V]);_==null&&Rn.delete(w)}let Qt=0,hn=0,F=0,Pe=0,Je=0,lt=0,we=Je,Ft=lt,Ge=F,Ze=Pe,C=0,S=0,q=0,ue=0;n.bbox={};let ae=!1,_e=!1,ye=!1,ne=!1,re=!1,me=!1;function U(_,w,P){(P||_!=n.width||w!=n.height)&&oe(_,w),dt(!1),ye=!0,_e=!0,Gn()}function oe(_,w){n.width=Qt=F=_,n.height=hn=Pe=w,Je=lt=0,Se(),Xe();let P=n.bbox;C=P.left=Kr(Je*Rt,.5),S=P.top=Kr(lt*Rt,.5),q=P.width=Kr(F*Rt,.5),ue=P.height=Kr(Pe*Rt,.5)}let ie=3;function Te(){let _=!1,w=0;for(;!_;){w++;let P=ro(w),N=os(w);_=w==ie||P&&N,_||(oe(n.width,n.height),_e=!0)}}function xe({width:_,height:w}){U(_,w)}n.setSize=xe;function Se(){let _=!1,w=!1,P=!1,N=!1;M.forEach((V,J)=>{if(V.show&&V._show){let{side:le,_size:pe}=V,be=le%2,Oe=V.label!=null?V.labelSize:0,Fe=pe+Oe;Fe>0&&(be?(F-=Fe,le==3?(Je+=Fe,N=!0):P=!0):(Pe-=Fe,le==0?(lt+=Fe,_=!0):w=!0))}}),ss[0]=_,ss[1]=P,ss[2]=w,ss[3]=N,F-=Gi[1]+Gi[3],Je+=Gi[3],Pe-=Gi[2]+Gi[0],lt+=Gi[0]}function Xe(){let _=Je+F,w=lt+Pe,P=Je,N=lt;function V(J,le){switch(J){case 1:return _+=le,_-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return N-=le,N+le}}M.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=V(pe,J._size),J.label!=null&&(J._lpos=V(pe,J.labelSize))}})}if(de.dataIdx==null){let _=de.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let P=_.prox=St(_.prox),N=_.bias??=0;de.dataIdx=(V,J,le,pe)=>{if(J==0)return le;let be=le,Oe=P(V,J,le,pe)??Bt,Fe=Oe>=0&&Oe<Bt,Be=L.ori==0?F:Pe,ot=de.left,Et=e[0],wt=e[J];if(w.has(wt[le])){be=null;let yt=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=le;yt==null&&Ye-- >0;)w.has(wt[Ye])||(yt=Ye);if(N==0||N==1)for(Ye=le;Qe==null&&Ye++<wt.length;)w.has(wt[Ye])||(Qe=Ye);if(yt!=null||Qe!=null)if(Fe){let qt=yt==null?-1/0:W(Et[yt],L,Be,0),nn=Qe==null?1/0:W(Et[Qe],L,Be,0),Ln=ot-qt,Ut=nn-ot;Ln<=Ut?Ln<=Oe&&(be=yt):Ut<=Oe&&(be=Qe)}else be=Qe==null?yt:yt==null?Qe:le-yt<=Qe-le?yt:Qe}else Fe&&En(ot-W(Et[le],L,Be,0))>Oe&&(be=null);return be}}let et=_=>{de.event=_};de.idxs=se,de._lock=!1;let he=de.points;he.show=St(he.show),he.size=St(he.size),he.stroke=St(he.stroke),he.width=St(he.width),he.fill=St(he.fill);let ze=n.focus=gn({},i.focus||{alpha:.3},de.focus),tt=ze.prox>=0,Ce=tt&&he.one,ht=[],Gt=[],Kn=[];function Sa(_,w){let P=he.show(n,w);if(P instanceof HTMLElement)return Mi(P,EE),Mi(P,_.class),Ms(P,-10,-10,F,Pe),p.insertBefore(P,ht[w]),P}function no(_,w){if(s==1||w>0){let P=s==1&&b[_.scale].time,N=_.value;_.value=P?Gx(N)?jx(Y,Kx(N,B)):N||ee:N||z1,_.label=_.label||(P?L1:I1)}if(Ce||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||eA||WE,_.fillTo=St(_.fillTo||X1),_.pxAlign=+Tt(_.pxAlign,v),_.pxRound=r_(_.pxAlign),_.stroke=St(_.stroke||null),_.fill=St(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=H1(ri(1,_.width),1),N=_.points=gn({},{size:P,width:ri(1,P*.2),stroke:_.stroke,space:P*2,paths:tA,_stroke:null,_fill:null},_.points);N.show=St(N.show),N.filter=St(N.filter),N.fill=St(N.fill),N.stroke=St(N.stroke),N.paths=St(N.paths),N.pxAlign=_.pxAlign}if(te){let P=Ot(_,w);at.splice(w,0,P[0]),We.splice(w,0,P[1]),fe.values.push(null)}if(ge){se.splice(w,0,null);let P=null;Ce?w==0&&(P=Sa(_,w)):w>0&&(P=Sa(_,w)),ht.splice(w,0,P),Gt.splice(w,0,0),Kn.splice(w,0,0)}In("addSeries",w)}function nd(_,w){w=w??y.length,_=s==1?Wp(_,w,Jx,i_):Wp(_,w,{},n_),y.splice(w,0,_),no(y[w],w)}n.addSeries=nd;function jl(_){if(y.splice(_,1),te){fe.values.splice(_,1),We.splice(_,1);let w=at.splice(_,1)[0];xn(null,w.firstChild),w.remove()}ge&&(se.splice(_,1),ht.splice(_,1)[0].remove(),Gt.splice(_,1),Kn.splice(_,1)),In("delSeries",_)}n.delSeries=jl;let ss=[!1,!1,!1,!1];function Ts(_,w){if(_._show=_.show,_.show){let P=_.side%2,N=b[_.scale];N==null&&(_.scale=P?y[1].scale:A,N=b[_.scale]);let V=N.time;_.size=St(_.size),_.space=St(_.space),_.rotate=St(_.rotate),vr(_.incrs)&&_.incrs.forEach(le=>{!yr.has(le)&&yr.set(le,__(le))}),_.incrs=St(_.incrs||(N.distr==2?d1:V?m==1?p1:x1:jr)),_.splits=St(_.splits||(V&&N.distr==1?ce:N.distr==3?zp:N.distr==4?O1:D1)),_.stroke=St(_.stroke),_.grid.stroke=St(_.grid.stroke),_.ticks.stroke=St(_.ticks.stroke),_.border.stroke=St(_.border.stroke);let J=_.values;_.values=vr(J)&&!vr(J[0])?St(J):V?vr(J)?Yx(Y,$x(J,B)):Gx(J)?y1(Y,J):J||Z:J||N1,_.filter=St(_.filter||(N.distr>=3&&N.log==10?k1:N.distr==3&&N.log==2?B1:g_)),_.font=c_(_.font),_.labelFont=c_(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(ss[w]=!0,_._el=ki(SE,d))}}function Es(_,w,P,N){let[V,J,le,pe]=P,be=w%2,Oe=0;return be==0&&(pe||J)&&(Oe=w==0&&!V||w==2&&!le?Tn(Zx.size/3):0),be==1&&(V||le)&&(Oe=w==1&&!J||w==3&&!pe?Tn(e_.size/2):0),Oe}let Ma=n.padding=(i.padding||[Es,Es,Es,Es]).map(_=>St(Tt(_,Es))),Gi=n._padding=Ma.map((_,w)=>_(n,w,ss,0)),en,rn=null,on=null,rs=s==1?y[0].idxs:null,di=null,Zs=!1;function wa(_,w){if(e=_??[],n.data=n._data=e,s==2){en=0;for(let P=1;P<y.length;P++)en+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),di=e[0],en=di.length;let P=e;if(G==2){P=e.slice();let N=P[0]=Array(en);for(let V=0;V<en;V++)N[V]=V}n._data=e=P}if(dt(!0),In("setData"),G==2&&(ye=!0),w!==!1){let P=L;P.auto(n,Zs)?Ta():er(A,P.min,P.max),ne=ne||de.left>=0,me=!0,Gn()}}n.setData=wa;function Ta(){Zs=!0;let _,w;s==1&&(en>0?(rn=rs[0]=0,on=rs[1]=en-1,_=e[0][rn],w=e[0][on],G==2?(_=rn,w=on):_==w&&(G==3?[_,w]=mu(_,_,L.log,!1):G==4?[_,w]=Yp(_,_,L.log,!1):L.time?w=_+Tn(86400/m):[_,w]=du(_,w,Kp,!0))):(rn=rs[0]=_=null,on=rs[1]=w=null)),er(A,_,w)}let io,Js,so,T,z,Q,K,j,Ee,Ie;function Ae(_,w,P,N,V,J){_??=Ex,P??=Zp,N??="butt",V??=Ex,J??="round",_!=io&&(u.strokeStyle=io=_),V!=Js&&(u.fillStyle=Js=V),w!=so&&(u.lineWidth=so=w),J!=z&&(u.lineJoin=z=J),N!=Q&&(u.lineCap=Q=N),P!=T&&u.setLineDash(T=P)}function Ne(_,w,P,N){w!=Js&&(u.fillStyle=Js=w),_!=K&&(u.font=K=_),P!=j&&(u.textAlign=j=P),N!=Ee&&(u.textBaseline=Ee=N)}function Ve(_,w,P,N,V=0){if(N.length>0&&_.auto(n,Zs)&&(w==null||w.min==null)){let J=Tt(rn,0),le=Tt(on,N.length-1),pe=P.min==null?kE(N,J,le,V,_.distr==3):[P.min,P.max];_.min=ts(_.min,P.min=pe[0]),_.max=ri(_.max,P.max=pe[1])}}let it={min:null,max:null};function _t(){for(let N in b){let V=b[N];H[N]==null&&(V.min==null||H[A]!=null&&V.auto(n,Zs))&&(H[N]=it)}for(let N in b){let V=b[N];H[N]==null&&V.from!=null&&H[V.from]!=null&&(H[N]=it)}H[A]!=null&&dt(!0);let _={};for(let N in H){let V=H[N];if(V!=null){let J=_[N]=ca(b[N],$E);if(V.min!=null)gn(J,V);else if(N!=A||s==2)if(en==0&&J.from==null){let le=J.range(n,null,null,N);J.min=le[0],J.max=le[1]}else J.min=Bt,J.max=-Bt}}if(en>0){y.forEach((N,V)=>{if(s==1){let J=N.scale,le=H[J];if(le==null)return;let pe=_[J];if(V==0){let be=pe.range(n,pe.min,pe.max,J);pe.min=be[0],pe.max=be[1],rn=es(pe.min,e[0]),on=es(pe.max,e[0]),on-rn>1&&(e[0][rn]<pe.min&&rn++,e[0][on]>pe.max&&on--),N.min=di[rn],N.max=di[on]}else N.show&&N.auto&&Ve(pe,le,N,e[V],N.sorted);N.idxs[0]=rn,N.idxs[1]=on}else if(V>0&&N.show&&N.auto){let[J,le]=N.facets,pe=J.scale,be=le.scale,[Oe,Fe]=e[V],Be=_[pe],ot=_[be];Be!=null&&Ve(Be,H[pe],J,Oe,J.sorted),ot!=null&&Ve(ot,H[be],le,Fe,le.sorted),N.min=le.min,N.max=le.max}});for(let N in _){let V=_[N],J=H[N];if(V.from==null&&(J==null||J.min==null)){let le=V.range(n,V.min==Bt?null:V.min,V.max==-Bt?null:V.max,N);V.min=le[0],V.max=le[1]}}}for(let N in _){let V=_[N];if(V.from!=null){let J=_[V.from];if(J.min==null)V.min=V.max=null;else{let le=V.range(n,J.min,J.max,N);V.min=le[0],V.max=le[1]}}}let w={},P=!1;for(let N in _){let V=_[N],J=b[N];if(J.min!=V.min||J.max!=V.max){J.min=V.min,J.max=V.max;let le=J.distr;J._min=le==3?Ys(J.min):le==4?Ip(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Ys(J.max):le==4?Ip(J.max,J.asinh):le==100?J.fwd(J.max):J.max,w[N]=P=!0}}if(P){y.forEach((N,V)=>{s==2?V>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)ye=!0,In("setScale",N);ge&&de.left>=0&&(ne=me=!0)}for(let N in H)H[N]=null}function He(_){let w=Bp(rn-1,0,en-1),P=Bp(on+1,0,en-1);for(;_[w]==null&&w>0;)w--;for(;_[P]==null&&P<en-1;)P++;return[w,P]}function vt(){if(en>0){let _=y.some(w=>w._focus)&&Ie!=ze.alpha;_&&(u.globalAlpha=Ie=ze.alpha),y.forEach((w,P)=>{if(P>0&&w.show&&(Zt(P,!1),Zt(P,!0),w._paths==null)){let N=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha);let V=s==2?[0,e[P][0].length-1]:He(e[P]);w._paths=w.paths(n,P,V[0],V[1]),Ie!=N&&(u.globalAlpha=Ie=N)}}),y.forEach((w,P)=>{if(P>0&&w.show){let N=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha),w._paths!=null&&It(P,!1);{let V=w._paths!=null?w._paths.gaps:null,J=w.points.show(n,P,rn,on,V),le=w.points.filter(n,P,J,V);(J||le)&&(w.points._paths=w.points.paths(n,P,rn,on,le),It(P,!0))}Ie!=N&&(u.globalAlpha=Ie=N),In("drawSeries",P)}}),_&&(u.globalAlpha=Ie=1)}}function Zt(_,w){let P=w?y[_].points:y[_];P._stroke=P.stroke(n,_),P._fill=P.fill(n,_)}function It(_,w){let P=w?y[_].points:y[_],{stroke:N,fill:V,clip:J,flags:le,_stroke:pe=P._stroke,_fill:be=P._fill,_width:Oe=P.width}=P._paths;Oe=zt(Oe*Rt,3);let Fe=null,Be=Oe%2/2;w&&be==null&&(be=Oe>0?"#fff":pe);let ot=P.pxAlign==1&&Be>0;if(ot&&u.translate(Be,Be),!w){let Et=C-Oe/2,wt=S-Oe/2,yt=q+Oe,Qe=ue+Oe;Fe=new Path2D,Fe.rect(Et,wt,yt,Qe)}w?ke(pe,Oe,P.dash,P.cap,be,N,V,le,J):Lt(_,pe,Oe,P.dash,P.cap,be,N,V,le,Fe,J),ot&&u.translate(-Be,-Be)}function Lt(_,w,P,N,V,J,le,pe,be,Oe,Fe){let Be=!1;be!=0&&R.forEach((ot,Et)=>{if(ot.series[0]==_){let wt=y[ot.series[1]],yt=e[ot.series[1]],Qe=(wt._paths||Ol).band;vr(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let Ye,qt=null;wt.show&&Qe&&zE(yt,rn,on)?(qt=ot.fill(n,Et)||J,Ye=wt._paths.clip):Qe=null,ke(w,P,N,V,qt,le,pe,be,Oe,Fe,Ye,Qe),Be=!0}}),Be||ke(w,P,N,V,J,le,pe,be,Oe,Fe)}let _n=ha|Vp;function ke(_,w,P,N,V,J,le,pe,be,Oe,Fe,Be){Ae(_,w,P,N,V),(be||Oe||Be)&&(u.save(),be&&u.clip(be),Oe&&u.clip(Oe)),Be?(pe&_n)==_n?(u.clip(Be),Fe&&u.clip(Fe),bt(V,le),un(_,J,w)):pe&Vp?(bt(V,le),u.clip(Be),un(_,J,w)):pe&ha&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),bt(V,le),u.restore(),un(_,J,w)):(bt(V,le),un(_,J,w)),(be||Oe||Be)&&u.restore()}function un(_,w,P){P>0&&(w instanceof Map?w.forEach((N,V)=>{u.strokeStyle=io=V,u.stroke(N)}):w!=null&&_&&u.stroke(w))}function bt(_,w){w instanceof Map?w.forEach((P,N)=>{u.fillStyle=Js=N,u.fill(P)}):w!=null&&_&&u.fill(w)}function As(_,w,P,N){let V=M[_],J;if(N<=0)J=[0,0];else{let le=V._space=V.space(n,_,w,P,N),pe=V._incrs=V.incrs(n,_,w,P,N,le);J=aA(w,P,pe,N,le)}return V._found=J}function dn(_,w,P,N,V,J,le,pe,be,Oe){let Fe=le%2/2;v==1&&u.translate(Fe,Fe),Ae(pe,le,be,Oe,pe),u.beginPath();let Be,ot,Et,wt,yt=V+(N==0||N==3?-J:J);P==0?(ot=V,wt=yt):(Be=V,Et=yt);for(let Qe=0;Qe<_.length;Qe++)w[Qe]!=null&&(P==0?Be=Et=_[Qe]:ot=wt=_[Qe],u.moveTo(Be,ot),u.lineTo(Et,wt));u.stroke(),v==1&&u.translate(-Fe,-Fe)}function ro(_){let w=!0;return M.forEach((P,N)=>{if(!P.show)return;let V=b[P.scale];if(V.min==null){P._show&&(w=!1,P._show=!1,dt(!1));return}else P._show||(w=!1,P._show=!0,dt(!1));let J=P.side,le=J%2,{min:pe,max:be}=V,[Oe,Fe]=As(N,pe,be,le==0?F:Pe);if(Fe==0)return;let Be=V.distr==2,ot=P._splits=P.splits(n,N,pe,be,Oe,Fe,Be),Et=V.distr==2?ot.map(Ye=>di[Ye]):ot,wt=V.distr==2?di[ot[1]]-di[ot[0]]:Oe,yt=P._values=P.values(n,P.filter(n,Et,N,Fe,wt),N,Fe,wt);P._rotate=J==2?P.rotate(n,yt,N,Fe):0;let Qe=P._size;P._size=Bi(P.size(n,yt,N,_)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function os(_){let w=!0;return Ma.forEach((P,N)=>{let V=P(n,N,ss,_);V!=Gi[N]&&(w=!1),Gi[N]=V}),w}function Rs(){for(let _=0;_<M.length;_++){let w=M[_];if(!w.show||!w._show)continue;let P=w.side,N=P%2,V,J,le=w.stroke(n,_),pe=P==0||P==3?-1:1,[be,Oe]=w._found;if(w.label!=null){let Jn=w.labelGap*pe,mi=Tn((w._lpos+Jn)*Rt);Ne(w.labelFont[0],le,"center",P==2?"top":Tx),u.save(),N==1?(V=J=0,u.translate(mi,Tn(S+ue/2)),u.rotate((P==3?-hu:hu)/2)):(V=Tn(C+q/2),J=mi);let Rr=p_(w.label)?w.label(n,_,be,Oe):w.label;u.fillText(Rr,V,J),u.restore()}if(Oe==0)continue;let Fe=b[w.scale],Be=N==0?q:ue,ot=N==0?C:S,Et=w._splits,wt=Fe.distr==2?Et.map(Jn=>di[Jn]):Et,yt=Fe.distr==2?di[Et[1]]-di[Et[0]]:be,Qe=w.ticks,Ye=w.border,qt=Qe.show?Qe.size:0,nn=Tn(qt*Rt),Ln=Tn((w.alignTo==2?w._size-qt-w.gap:w.gap)*Rt),Ut=w._rotate*-hu/180,sn=g(w._pos*Rt),fi=(nn+Ln)*pe,Zn=sn+fi;J=N==0?Zn:0,V=N==1?Zn:0;let Ri=w.font[0],Wi=w.align==1?sa:w.align==2?Rp:Ut>0?sa:Ut<0?Rp:N==0?"center":P==3?Rp:sa,cs=Ut||N==1?"middle":P==2?"top":Tx;Ne(Ri,le,Wi,cs);let pi=w.font[1]*w.lineGap,Ci=Et.map(Jn=>g(a(Jn,Fe,Be,ot))),Xi=w._values;for(let Jn=0;Jn<Xi.length;Jn++){let mi=Xi[Jn];if(mi!=null){N==0?V=Ci[Jn]:J=Ci[Jn],mi=""+mi;let Rr=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let Qn=0;Qn<Rr.length;Qn++){let jm=Rr[Qn];Ut?(u.save(),u.translate(V,J+Qn*pi),u.rotate(Ut),u.fillText(jm,0,0),u.restore()):u.fillText(jm,V,J+Qn*pi)}}}Qe.show&&dn(Ci,Qe.filter(n,wt,_,Oe,yt),N,P,sn,nn,zt(Qe.width*Rt,3),Qe.stroke(n,_),Qe.dash,Qe.cap);let hs=w.grid;hs.show&&dn(Ci,hs.filter(n,wt,_,Oe,yt),N,N==0?2:1,N==0?S:C,N==0?ue:q,zt(hs.width*Rt,3),hs.stroke(n,_),hs.dash,hs.cap),Ye.show&&dn([sn],[1],N==0?1:0,N==0?1:2,N==1?S:C,N==1?ue:q,zt(Ye.width*Rt,3),Ye.stroke(n,_),Ye.dash,Ye.cap)}In("drawAxes")}function dt(_){y.forEach((w,P)=>{P>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let tn=!1,jn=!1,Nt=[];function fn(){jn=!1;for(let _=0;_<Nt.length;_++)In(...Nt[_]);Nt.length=0}function Gn(){tn||(e1(Lm),tn=!0)}function Zl(_,w=!1){tn=!0,jn=w,_(n),Lm(),w&&Nt.length>0&&queueMicrotask(fn)}n.batch=Zl;function Lm(){if(ae&&(_t(),ae=!1),ye&&(Te(),ye=!1),_e){if($t(f,sa,Je),$t(f,"top",lt),$t(f,Il,F),$t(f,Ll,Pe),$t(p,sa,Je),$t(p,"top",lt),$t(p,Il,F),$t(p,Ll,Pe),$t(d,Il,Qt),$t(d,Ll,hn),h.width=Tn(Qt*Rt),h.height=Tn(hn*Rt),M.forEach(({_el:_,_show:w,_size:P,_pos:N,side:V})=>{if(_!=null)if(w){let J=V===3||V===0?P:0,le=V%2==1;$t(_,le?"left":"top",N-J),$t(_,le?"width":"height",P),$t(_,le?"top":"left",le?lt:Je),$t(_,le?"height":"width",le?Pe:F),Fp(_,Zr)}else Mi(_,Zr)}),io=Js=so=z=Q=K=j=Ee=T=null,Ie=1,Ra(!0),Je!=we||lt!=Ft||F!=Ge||Pe!=Ze){dt(!1);let _=F/Ge,w=Pe/Ze;if(ge&&!ne&&de.left>=0){de.left*=_,de.top*=w,oo&&Ms(oo,Tn(de.left),0,F,Pe),ao&&Ms(ao,0,Tn(de.top),F,Pe);for(let P=0;P<ht.length;P++){let N=ht[P];N!=null&&(Gt[P]*=_,Kn[P]*=w,Ms(N,Bi(Gt[P]),Bi(Kn[P]),F,Pe))}}if(Xt.show&&!re&&Xt.left>=0&&Xt.width>0){Xt.left*=_,Xt.width*=_,Xt.top*=w,Xt.height*=w;for(let P in ld)$t(ho,P,Xt[P])}we=Je,Ft=lt,Ge=F,Ze=Pe}In("setSize"),_e=!1}Qt>0&&hn>0&&(u.clearRect(0,0,h.width,h.height),In("drawClear"),E.forEach(_=>_()),In("draw")),Xt.show&&re&&(Jl(Xt),re=!1),ge&&ne&&(Ar(null,!0,!1),ne=!1),fe.show&&fe.live&&me&&(od(),me=!1),c||(c=!0,n.status=1,In("ready")),Zs=!1,tn=!1}n.redraw=(_,w)=>{ye=w||!1,_!==!1?er(A,L.min,L.max):Gn()};function id(_,w){let P=b[_];if(P.from==null){if(en==0){let N=P.range(n,w.min,w.max,_);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(en>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==A&&P.distr==2&&en>0&&(w.min=es(w.min,e[0]),w.max=es(w.max,e[0]),w.min==w.max&&w.max++),H[_]=w,ae=!0,Gn()}}n.setScale=id;let sd,rd,oo,ao,Nm,Dm,lo,co,Om,Um,Wt,Kt,Qs=!1,kn=de.drag,Cn=kn.x,Pn=kn.y;ge&&(de.x&&(sd=ki(wE,p)),de.y&&(rd=ki(TE,p)),L.ori==0?(oo=sd,ao=rd):(oo=rd,ao=sd),Wt=de.left,Kt=de.top);let Xt=n.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ho=Xt.show?ki(ME,Xt.over?p:f):null;function Jl(_,w){if(Xt.show){for(let P in _)Xt[P]=_[P],P in ld&&$t(ho,P,_[P]);w!==!1&&In("setSelect")}}n.setSelect=Jl;function Gv(_){if(y[_].show)te&&Fp(at[_],Zr);else if(te&&Mi(at[_],Zr),ge){let P=Ce?ht[0]:ht[_];P!=null&&Ms(P,-10,-10,F,Pe)}}function er(_,w,P){id(_,{min:w,max:P})}function as(_,w,P,N){w.focus!=null&&Yv(_),w.show!=null&&y.forEach((V,J)=>{J>0&&(_==J||_==null)&&(V.show=w.show,Gv(J),s==2?(er(V.facets[0].scale,null,null),er(V.facets[1].scale,null,null)):er(V.scale,null,null),Gn())}),P!==!1&&In("setSeries",_,w),N&&Ca("setSeries",n,_,w)}n.setSeries=as;function Wv(_,w){gn(R[_],w)}function Xv(_,w){_.fill=St(_.fill||null),_.dir=Tt(_.dir,-1),w=w??R.length,R.splice(w,0,_)}function qv(_){_==null?R.length=0:R.splice(_,1)}n.addBand=Xv,n.setBand=Wv,n.delBand=qv;function $v(_,w){y[_].alpha=w,ge&&ht[_]!=null&&(ht[_].style.opacity=w),te&&at[_]&&(at[_].style.opacity=w)}let Cs,tr,Er,uo={focus:!0};function Yv(_){if(_!=Er){let w=_==null,P=ze.alpha!=1;y.forEach((N,V)=>{if(s==1||V>0){let J=w||V==0||V==_;N._focus=w?null:J,P&&$v(V,J?1:ze.alpha)}}),Er=_,P&&Gn()}}te&&tt&&Mt(Cx,Re,_=>{de._lock||(et(_),Er!=null&&as(null,uo,!0,pn.setSeries))});function ls(_,w,P){let N=b[w];P&&(_=_/Rt-(N.ori==1?lt:Je));let V=F;N.ori==1&&(V=Pe,_=V-_),N.dir==-1&&(_=V-_);let J=N._min,le=N._max,pe=_/V,be=J+(le-J)*pe,Oe=N.distr;return Oe==3?aa(10,be):Oe==4?VE(be,N.asinh):Oe==100?N.bwd(be):be}function Kv(_,w){let P=ls(_,A,w);return es(P,e[0],rn,on)}n.valToIdx=_=>es(_,e[0]),n.posToIdx=Kv,n.posToVal=ls,n.valToPos=(_,w,P)=>b[w].ori==0?r(_,b[w],P?q:F,P?C:0):o(_,b[w],P?ue:Pe,P?S:0),n.setCursor=(_,w,P)=>{Wt=_.left,Kt=_.top,Ar(null,w,P)};function Fm(_,w){$t(ho,sa,Xt.left=_),$t(ho,Il,Xt.width=w)}function km(_,w){$t(ho,"top",Xt.top=_),$t(ho,Ll,Xt.height=w)}let Ea=L.ori==0?Fm:km,Aa=L.ori==1?Fm:km;function jv(){if(te&&fe.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ut)continue;let w=fe.values[_],P=0;for(let N in w)We[_][P++].firstChild.nodeValue=w[N]}}function od(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{se[N]=P}):qE(_.idx)||se.fill(_.idx),fe.idx=se[0]),te&&fe.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!ut)&&Zv(P,se[P]);jv()}me=!1,w!==!1&&In("setLegend")}n.setLegend=od;function Zv(_,w){let P=y[_],N=_==0&&G==2?di:e[_],V;ut?V=P.values(n,_,w)??rt:(V=P.value(n,w==null?null:N[w],_,w),V=V==null?rt:{_:V}),fe.values[_]=V}function Ar(_,w,P){Om=Wt,Um=Kt,[Wt,Kt]=de.move(n,Wt,Kt),de.left=Wt,de.top=Kt,ge&&(oo&&Ms(oo,Tn(Wt),0,F,Pe),ao&&Ms(ao,0,Tn(Kt),F,Pe));let N,V=rn>on;Cs=Bt,tr=null;let J=L.ori==0?F:Pe,le=L.ori==1?F:Pe;if(Wt<0||en==0||V){N=de.idx=null;for(let pe=0;pe<y.length;pe++){let be=ht[pe];be!=null&&Ms(be,-10,-10,F,Pe)}tt&&as(null,uo,!0,_==null&&pn.setSeries),fe.live&&(se.fill(N),me=!0)}else{let pe,be,Oe;s==1&&(pe=L.ori==0?Wt:Kt,be=ls(pe,A),N=de.idx=es(be,e[0],rn,on),Oe=W(e[0][N],L,J,0));let Fe=-10,Be=-10,ot=0,Et=0,wt=!0,yt="",Qe="";for(let Ye=s==2?1:0;Ye<y.length;Ye++){let qt=y[Ye],nn=se[Ye],Ln=nn==null?null:s==1?e[Ye][nn]:e[Ye][1][nn],Ut=de.dataIdx(n,Ye,N,be),sn=Ut==null?null:s==1?e[Ye][Ut]:e[Ye][1][Ut];if(me=me||sn!=Ln||Ut!=nn,se[Ye]=Ut,Ye>0&&qt.show){let fi=Ut==null?-10:Ut==N?Oe:W(s==1?e[0][Ut]:e[Ye][0][Ut],L,J,0),Zn=sn==null?-10:O(sn,s==1?b[qt.scale]:b[qt.facets[1].scale],le,0);if(tt&&sn!=null){let Ri=L.ori==1?Wt:Kt,Wi=En(ze.dist(n,Ye,Ut,Zn,Ri));if(Wi<Cs){let cs=ze.bias;if(cs!=0){let pi=ls(Ri,qt.scale),Ci=sn>=0?1:-1,Xi=pi>=0?1:-1;Xi==Ci&&(Xi==1?cs==1?sn>=pi:sn<=pi:cs==1?sn<=pi:sn>=pi)&&(Cs=Wi,tr=Ye)}else Cs=Wi,tr=Ye}}if(me||Ce){let Ri,Wi;L.ori==0?(Ri=fi,Wi=Zn):(Ri=Zn,Wi=fi);let cs,pi,Ci,Xi,hs,Jn,mi=!0,Rr=he.bbox;if(Rr!=null){mi=!1;let Qn=Rr(n,Ye);Ci=Qn.left,Xi=Qn.top,cs=Qn.width,pi=Qn.height}else Ci=Ri,Xi=Wi,cs=pi=he.size(n,Ye);if(Jn=he.fill(n,Ye),hs=he.stroke(n,Ye),Ce)Ye==tr&&Cs<=ze.prox&&(Fe=Ci,Be=Xi,ot=cs,Et=pi,wt=mi,yt=Jn,Qe=hs);else{let Qn=ht[Ye];Qn!=null&&(Gt[Ye]=Ci,Kn[Ye]=Xi,Ux(Qn,cs,pi,mi),Dx(Qn,Jn,hs),Ms(Qn,Bi(Ci),Bi(Xi),F,Pe))}}}}if(Ce){let Ye=ze.prox,qt=Er==null?Cs<=Ye:Cs>Ye||tr!=Er;if(me||qt){let nn=ht[0];nn!=null&&(Gt[0]=Fe,Kn[0]=Be,Ux(nn,ot,Et,wt),Dx(nn,yt,Qe),Ms(nn,Bi(Fe),Bi(Be),F,Pe))}}}if(Xt.show&&Qs)if(_!=null){let[pe,be]=pn.scales,[Oe,Fe]=pn.match,[Be,ot]=_.cursor.sync.scales,Et=_.cursor.drag;if(Cn=Et._x,Pn=Et._y,Cn||Pn){let{left:wt,top:yt,width:Qe,height:Ye}=_.select,qt=_.scales[Be].ori,nn=_.posToVal,Ln,Ut,sn,fi,Zn,Ri=pe!=null&&Oe(pe,Be),Wi=be!=null&&Fe(be,ot);Ri&&Cn?(qt==0?(Ln=wt,Ut=Qe):(Ln=yt,Ut=Ye),sn=b[pe],fi=W(nn(Ln,Be),sn,J,0),Zn=W(nn(Ln+Ut,Be),sn,J,0),Ea(ts(fi,Zn),En(Zn-fi))):Ea(0,J),Wi&&Pn?(qt==1?(Ln=wt,Ut=Qe):(Ln=yt,Ut=Ye),sn=b[be],fi=O(nn(Ln,ot),sn,le,0),Zn=O(nn(Ln+Ut,ot),sn,le,0),Aa(ts(fi,Zn),En(Zn-fi))):Aa(0,le)}else cd()}else{let pe=En(Om-Nm),be=En(Um-Dm);if(L.ori==1){let ot=pe;pe=be,be=ot}Cn=kn.x&&pe>=kn.dist,Pn=kn.y&&be>=kn.dist;let Oe=kn.uni;Oe!=null?Cn&&Pn&&(Cn=pe>=Oe,Pn=be>=Oe,!Cn&&!Pn&&(be>pe?Pn=!0:Cn=!0)):kn.x&&kn.y&&(Cn||Pn)&&(Cn=Pn=!0);let Fe,Be;Cn&&(L.ori==0?(Fe=lo,Be=Wt):(Fe=co,Be=Kt),Ea(ts(Fe,Be),En(Be-Fe)),Pn||Aa(0,le)),Pn&&(L.ori==1?(Fe=lo,Be=Wt):(Fe=co,Be=Kt),Aa(ts(Fe,Be),En(Be-Fe)),Cn||Ea(0,J)),!Cn&&!Pn&&(Ea(0,0),Aa(0,0))}if(kn._x=Cn,kn._y=Pn,_==null){if(P){if(Km!=null){let[pe,be]=pn.scales;pn.values[0]=pe!=null?ls(L.ori==0?Wt:Kt,pe):null,pn.values[1]=be!=null?ls(L.ori==1?Wt:Kt,be):null}Ca(Cp,n,Wt,Kt,F,Pe,N)}if(tt){let pe=P&&pn.setSeries,be=ze.prox;Er==null?Cs<=be&&as(tr,uo,!0,pe):Cs>be?as(null,uo,!0,pe):tr!=Er&&as(tr,uo,!0,pe)}}me&&(fe.idx=N,od()),w!==!1&&In("setCursor")}let nr=null;Object.defineProperty(n,"rect",{get(){return nr==null&&Ra(!1),nr}});function Ra(_=!1){_?nr=null:(nr=p.getBoundingClientRect(),In("syncRect",nr))}function Bm(_,w,P,N,V,J,le){de._lock||Qs&&_!=null&&_.movementX==0&&_.movementY==0||(ad(_,w,P,N,V,J,le,!1,_!=null),_!=null?Ar(null,!0,!0):Ar(w,!0,!1))}function ad(_,w,P,N,V,J,le,pe,be){if(nr==null&&Ra(!1),et(_),_!=null)P=_.clientX-nr.left,N=_.clientY-nr.top;else{if(P<0||N<0){Wt=-10,Kt=-10;return}let[Oe,Fe]=pn.scales,Be=w.cursor.sync,[ot,Et]=Be.values,[wt,yt]=Be.scales,[Qe,Ye]=pn.match,qt=w.axes[0].side%2==1,nn=L.ori==0?F:Pe,Ln=L.ori==1?F:Pe,Ut=qt?J:V,sn=qt?V:J,fi=qt?N:P,Zn=qt?P:N;if(wt!=null?P=Qe(Oe,wt)?a(ot,b[Oe],nn,0):-10:P=nn*(fi/Ut),yt!=null?N=Ye(Fe,yt)?a(Et,b[Fe],Ln,0):-10:N=Ln*(Zn/sn),L.ori==1){let Ri=P;P=N,N=Ri}}be&&(w==null||w.cursor.event.type==Cp)&&((P<=1||P>=F-1)&&(P=Kr(P,F)),(N<=1||N>=Pe-1)&&(N=Kr(N,Pe))),pe?(Nm=P,Dm=N,[lo,co]=de.move(n,P,N)):(Wt=P,Kt=N)}let ld={width:0,height:0,left:0,top:0};function cd(){Jl(ld,!1)}let zm,Hm,Vm,Gm;function Wm(_,w,P,N,V,J,le){Qs=!0,Cn=Pn=kn._x=kn._y=!1,ad(_,w,P,N,V,J,le,!0,!1),_!=null&&(Mt(Pp,Op,Xm,!1),Ca(Ax,n,lo,co,F,Pe,null));let{left:pe,top:be,width:Oe,height:Fe}=Xt;zm=pe,Hm=be,Vm=Oe,Gm=Fe}function Xm(_,w,P,N,V,J,le){Qs=kn._x=kn._y=!1,ad(_,w,P,N,V,J,le,!1,!0);let{left:pe,top:be,width:Oe,height:Fe}=Xt,Be=Oe>0||Fe>0,ot=zm!=pe||Hm!=be||Vm!=Oe||Gm!=Fe;if(Be&&ot&&Jl(Xt),kn.setScale&&Be&&ot){let Et=pe,wt=Oe,yt=be,Qe=Fe;if(L.ori==1&&(Et=be,wt=Fe,yt=pe,Qe=Oe),Cn&&er(A,ls(Et,A),ls(Et+wt,A)),Pn)for(let Ye in b){let qt=b[Ye];Ye!=A&&qt.from==null&&qt.min!=Bt&&er(Ye,ls(yt+Qe,Ye),ls(yt,Ye))}cd()}else de.lock&&(de._lock=!de._lock,Ar(w,!0,_!=null));_!=null&&(xn(Pp,Op),Ca(Pp,n,Wt,Kt,F,Pe,null))}function Jv(_,w,P,N,V,J,le){if(de._lock)return;et(_);let pe=Qs;if(Qs){let be=!0,Oe=!0,Fe=10,Be,ot;L.ori==0?(Be=Cn,ot=Pn):(Be=Pn,ot=Cn),Be&&ot&&(be=Wt<=Fe||Wt>=F-Fe,Oe=Kt<=Fe||Kt>=Pe-Fe),Be&&be&&(Wt=Wt<lo?0:F),ot&&Oe&&(Kt=Kt<co?0:Pe),Ar(null,!0,!0),Qs=!1}Wt=-10,Kt=-10,se.fill(null),Ar(null,!0,!0),pe&&(Qs=pe)}function qm(_,w,P,N,V,J,le){de._lock||(et(_),Ta(),cd(),_!=null&&Ca(Px,n,Wt,Kt,F,Pe,null))}function $m(){M.forEach(lA),U(n.width,n.height,!0)}Jr(uu,oa,$m);let fo={};fo.mousedown=Wm,fo.mousemove=Bm,fo.mouseup=Xm,fo.dblclick=qm,fo.setSeries=(_,w,P,N)=>{let V=pn.match[2];P=V(n,w,P),P!=-1&&as(P,N,!0,!1)},ge&&(Mt(Ax,p,Wm),Mt(Cp,p,Bm),Mt(Rx,p,_=>{et(_),Ra(!1)}),Mt(Cx,p,Jv),Mt(Px,p,qm),Gp.add(n),n.syncRect=Ra);let Ql=n.hooks=i.hooks||{};function In(_,w,P){jn?Nt.push([_,w,P]):_ in Ql&&Ql[_].forEach(N=>{N.call(null,n,w,P)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)Ql[w]=(Ql[w]||[]).concat(_.hooks[w])});let Ym=(_,w,P)=>P,pn=gn({key:null,setSeries:!1,filters:{pub:Hx,sub:Hx},scales:[A,y[1]?y[1].scale:null],match:[Vx,Vx,Ym],values:[null,null]},de.sync);pn.match.length==2&&pn.match.push(Ym),de.sync=pn;let Km=pn.key,hd=k_(Km);function Ca(_,w,P,N,V,J,le){pn.filters.pub(_,w,P,N,V,J,le)&&hd.pub(_,w,P,N,V,J,le)}hd.sub(n);function Qv(_,w,P,N,V,J,le){pn.filters.sub(_,w,P,N,V,J,le)&&fo[_](null,w,P,N,V,J,le)}n.pub=Qv;function ey(){hd.unsub(n),Gp.delete(n),Rn.clear(),kp(uu,oa,$m),l.remove(),Re?.remove(),In("destroy")}n.destroy=ey;function ud(){In("init",i,e),wa(e||i.data,!1),H[A]?id(A,H[A]):Ta(),re=Xt.show&&(Xt.width>0||Xt.height>0),ne=me=!0,U(i.width,i.height)}return y.forEach(no),M.forEach(Ts),t?t instanceof HTMLElement?(t.appendChild(l),ud()):t(n,ud):ud(),n}Hn.assign=gn;Hn.fmtNum=jp;Hn.rangeNum=du;Hn.rangeLog=mu;Hn.rangeAsinh=Yp;Hn.orient=eo;Hn.pxRatio=Rt;Hn.join=QE;Hn.fmtDate=Jp,Hn.tzDate=h1;Hn.sync=k_;{Hn.addGap=q1,Hn.clipGaps=_u;let i=Hn.paths={points:W_};i.linear=q_,i.stepped=K1,i.bars=j1,i.spline=J1}var cA=11;function j_(i,e,t,n){let s=i.ctx,{left:r,width:o}=i.bbox,a=cA*devicePixelRatio,c=[],l=e.map((u,d)=>d),h=u=>n.includes(e[u])?0:u===0||u===e.length-1?1:2;l.sort((u,d)=>h(u)-h(d)||u-d),s.save(),s.font=`${10*devicePixelRatio}px system-ui`,s.textBaseline="middle",s.textAlign="left";for(let u of l){let d=i.valToPos(t(u),"y",!0);c.some(f=>Math.abs(f-d)<a)||(c.push(d),s.fillStyle=Le(h(u)===0?"--accent":"--ink-soft"),s.fillText(String(e[u]),r+o+4*devicePixelRatio,d))}s.restore()}function Mu(i){let e=new DataView(i).getUint32(0,!0);return{...JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e))),values:new Float32Array(i,4+e)}}function rm(i,e){return`${i} ${e.includes("/")?"of":"at"} ${e}`}var hA=24,uA=150,dA=20,fA=22,Su=class{constructor(e,t,n,s,r){this.place=e;this.titles=t;this.colourOf=n;this.choose=s;this.hover=r;I("axis").addEventListener("change",()=>this.restyle()),new ResizeObserver(()=>this.fit()).observe(e)}place;titles;colourOf;choose;hover;now=null;pinned=null;plots=[];sheets=[];lit=null;pointed=null;other=null;low=0;high=1;key="";get revision(){return this.now?.revision??-1}take(e){e.stage==="pinned"?this.pinned=e:this.now=e,this.now&&this.draw()}outdate(){this.now&&(this.now.revision=-1),this.pinned=null}unpin(){this.pinned=null,this.now&&this.draw()}light(e,t=null){[this.lit,this.other]=[e,t],this.repaint()}point(e){e!==this.pointed&&(this.pointed=e,this.repaint())}repaint(){for(let e of this.plots)e.redraw(!1)}restyle(){this.key="",this.now&&this.draw()}draw(){let e=this.now;I("validity-chip").hidden=!1,I("validity-words").textContent=e.validity,this.range();let t=[e.quantity,e.unit,...e.heard_by].join("|");t!==this.key&&this.build(t);for(let n of this.plots)n.setData([e.frequency,e.frequency.map(()=>null)],!0);document.documentElement.dataset.painted=String(e.revision)}range(){let e=1/0,t=-1/0;for(let s of[this.now,this.comparable()])for(let r of s?.values??[])r<e&&(e=r),r>t&&(t=r);let n=Math.max((t-e)*.05,.1);[this.low,this.high]=[e-n,t+n]}comparable(){return this.pinned&&this.pinned.quantity===this.now?.quantity?this.pinned:null}build(e){this.key=e;for(let s of this.plots)s.destroy();this.place.replaceChildren();let t=this.now,n=this.titles()[t.quantity]??t.quantity;this.plots=t.heard_by.map((s,r)=>{let o=$("figure",{class:"plot"},$("figcaption",{},rm(n,s)));this.place.append(o);let a={stroke:Le("--ink-soft"),grid:{stroke:Le("--grid"),width:1},ticks:{stroke:Le("--grid")},font:"12px system-ui",labelFont:"12px system-ui",labelSize:20},c=new Hn({width:this.width(),height:this.height(),padding:[null,fA,null,null],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{x:!1,y:!1}},scales:{x:{time:!1,distr:I("axis").value==="linear"?1:3},y:{range:()=>[this.low,this.high]}},axes:[{...a,label:"frequency (Hz)",size:34,filter:(l,h)=>h,values:(l,h)=>h.map(u=>I("axis").value==="linear"||/^[125]/.test(String(u))?String(u):"")},{...a,label:`${n.split(",")[0]} (${t.unit})`,size:54}],series:[{},{paths:()=>null,points:{show:!1}}],hooks:{draw:[l=>this.paint(l,r)],setCursor:[l=>this.read(l,r)]}},[t.frequency,t.frequency.map(()=>null)],o);return c.over.addEventListener("click",l=>this.choose(this.near(c,r)?.point??null,l.shiftKey)),c.over.addEventListener("mouseleave",()=>{I("pointed-curve").textContent="\xA0",this.hover(null)}),c.ctx.canvas.setAttribute("role","img"),c.ctx.canvas.setAttribute("aria-label",`${rm(n,s)} over frequency, a curve for each of ${t.points.length} points; CSV has the values`),c})}across(){let e=this.place.clientWidth,t=this.now?.heard_by.length??1;return t===1?1:e>1100&&t>2?3:e>560?2:1}width(){let e=this.place.clientWidth,t=this.across();return Math.max(Math.floor((e-12*(t-1))/t),220)}height(){let e=Math.ceil((this.now?.heard_by.length??1)/this.across());return Math.max(Math.floor(this.place.clientHeight/Math.min(e,2))-dA-4,uA)}fit(){let e=this.width(),t=this.height();for(let n of this.plots)(n.width!==e||n.height!==t)&&n.setSize({width:e,height:t})}paint(e,t){let{left:n,top:s,width:r,height:o}=e.bbox,a=this.sheets[t]??=$("canvas");a.width=r,a.height=o;let c=a.getContext("2d",{willReadFrequently:!0});c.translate(-n,-s),c.lineJoin="round";for(let u of[this.comparable(),this.now]){if(!u||t>=u.heard_by.length)continue;c.setLineDash(u===this.now?[]:[5*devicePixelRatio,4*devicePixelRatio]);let d=u.frequency.map(g=>e.valToPos(g,"x",!0)),f=e.valToPos(0,"y",!0),p=e.valToPos(1,"y",!0)-f,v=g=>{let m=(g*u.heard_by.length+t)*d.length;c.beginPath();for(let y=0;y<d.length;y++)c.lineTo(d[y],f+p*u.values[m+y]);c.stroke()};u.points.forEach((g,m)=>{g===this.lit||g===this.pointed||g===this.other||(c.globalAlpha=this.lit===null?u===this.now?1:.6:.22,c.lineWidth=1.4*devicePixelRatio,c.strokeStyle=this.colourOf(g),v(m))});for(let[g,m]of[[this.other,"--ink"],[this.pointed,""],[this.lit,"--accent"]]){let y=g===null?-1:u.points.indexOf(g);y<0||(c.globalAlpha=1,c.lineWidth=3*devicePixelRatio,c.strokeStyle=m?Le(m):this.colourOf(g),v(y))}}e.ctx.drawImage(a,n,s);let l=this.now,h=l.frequency.length;j_(e,l.points,u=>l.values[(u*l.heard_by.length+t)*h+h-1],[this.lit,this.pointed,this.other])}near(e,t){let n=this.now,{left:s,top:r}=e.cursor;if(!n||s===void 0||r===void 0||s<0)return null;let o=e.posToVal(s,"x"),a=0;for(let h=0;h<n.frequency.length;h++)Math.abs(Math.log(n.frequency[h]/o))<Math.abs(Math.log(n.frequency[a]/o))&&(a=h);let c=null,l=hA;return n.points.forEach((h,u)=>{let d=n.values[(u*n.heard_by.length+t)*n.frequency.length+a],f=Math.abs(e.valToPos(d,"y")-r);f<l&&(l=f,c={point:h,at:a,value:d})}),c}read(e,t){let n=this.near(e,t),s=this.now;if(!n||!s)return;this.hover(n.point);let r=a=>s.values[(s.points.indexOf(a)*s.heard_by.length+t)*s.frequency.length+n.at],o=this.lit&&this.other?`; point ${this.lit} less point ${this.other}: ${Ue(r(this.lit)-r(this.other))} ${s.unit}`:"";I("pointed-curve").textContent=`point ${n.point} at ${s.heard_by[t]}: ${Ue(n.value)} ${s.unit} at ${Ue(s.frequency[n.at],3)} Hz${o}`}table(e){let t=this.now;if(!t)return;let n=[["frequency (Hz)",...t.points.flatMap(s=>t.heard_by.map(r=>`point ${s} at ${r} (${t.unit})`))]];t.frequency.forEach((s,r)=>{n.push([s,...Array.from({length:t.points.length*t.heard_by.length},(o,a)=>Number(t.values[a*t.frequency.length+r].toPrecision(7)))])}),Ji(n,`${e}-${t.quantity}.csv`)}picture(e){let t=this.now;if(!t||!this.plots.length)return;let n=this.titles()[t.quantity],s=devicePixelRatio,r=24*s,o=this.plots.map(h=>h.ctx.canvas),a=$("canvas",{width:String(Math.max(...o.map(h=>h.width))),height:String(o.reduce((h,u)=>h+u.height+r,0))}),c=a.getContext("2d");c.fillStyle=Le("--card"),c.fillRect(0,0,a.width,a.height);let l=0;o.forEach((h,u)=>{c.fillStyle=Le("--ink"),c.font=`${14*s}px system-ui`,c.fillText(`${e}: ${rm(n,t.heard_by[u])}`,12*s,l+17*s),c.drawImage(h,0,l+r),l+=h.height+r}),a.toBlob(h=>h&&Si(h,`${e}-${t.quantity}.png`))}};function Fl(i,e,t="",n=[]){let s=1/0,r=-1/0;for(let a of i)a<s&&(s=a),a>r&&(r=a);let o=(r-s)*.06||Math.abs(r)*.1||1;return{low:s-o,high:r+o,title:t&&t!=="1"?`${e} (${bi(t)})`:e,labels:n}}function Ei(i,e,t){let n=devicePixelRatio,s=Math.round(e*n),r=Math.round(t*n);(i.width!==s||i.height!==r||!i.style.width)&&(i.width=s,i.height=r,i.style.width=`${e}px`,i.style.height=`${t}px`),i.getContext("2d",{willReadFrequently:!0}).reset()}var br=58,wu=10,Tu=8;function am(i,e,t,n,s){Ei(i,e,t);let r=i.getContext("2d");r.scale(devicePixelRatio,devicePixelRatio);let o=n.labels.length>0,a=o?74:38,c=u=>br+(u-n.low)/(n.high-n.low)*(e-br-wu),l=u=>t-a-(u-s.low)/(s.high-s.low)*(t-Tu-a);r.font="11px system-ui",r.lineWidth=1,r.strokeStyle=Le("--grid"),r.fillStyle=Le("--ink-soft"),r.textAlign="center",r.textBaseline="top";let h=Z_(n,(e-br-wu)/70);for(let u of h)om(r,c(u),Tu,c(u),t-a),r.save(),r.translate(c(u),t-a+4),o&&(r.rotate(-Math.PI/7),r.textAlign="right"),r.fillText(J_(n,u),o?8:0,0,o?Math.min(95,c(u)):70),r.restore();r.textAlign="right",r.textBaseline="middle";for(let u of Z_(s,(t-Tu-a)/34))om(r,br,l(u),e-wu,l(u)),r.fillText(J_(s,u),br-5,l(u),br-20);return r.fillStyle=Le("--ink"),r.textAlign="center",r.textBaseline="bottom",r.fillText(n.title,(br+e-wu)/2,t-2,e-br),r.save(),r.translate(2,(Tu+t-a)/2),r.rotate(-Math.PI/2),r.textBaseline="top",r.fillText(s.title,0,0,t-a),r.restore(),{c:r,x:c,y:l}}function om(i,e,t,n,s){i.beginPath(),i.moveTo(e,t),i.lineTo(n,s),i.stroke()}function Z_(i,e){if(i.labels.length)return i.labels.map((o,a)=>a);let t=(i.high-i.low)/Math.max(e,2),n=10**Math.floor(Math.log10(t)),s=[1,2,5,10].map(o=>o*n).find(o=>o>=t),r=[];for(let o=Math.ceil(i.low/s);o*s<=i.high;o++)r.push(o*s);return r}function J_(i,e){return i.labels[e]??Ue(e,3)}function lm(i,e){let t=i.map(l=>l.map(h=>typeof h=="number"?Ue(h):h)),n=22,s=12,r=document.createElement("canvas"),o=r.getContext("2d");o.font="13px system-ui";let a=t[0].map((l,h)=>Math.max(...t.map(u=>o.measureText(u[h]??"").width))+2*s);Ei(r,a.reduce((l,h)=>l+h,0),n*i.length);let c=r.getContext("2d");c.scale(devicePixelRatio,devicePixelRatio),c.font="13px system-ui",c.textBaseline="middle",c.strokeStyle=Le("--grid"),t.forEach((l,h)=>{c.fillStyle=Le(h?"--ink":"--ink-soft");let u=s;l.forEach((d,f)=>{c.fillText(d,u,(h+.5)*n),u+=a[f]}),om(c,0,(h+1)*n,u,(h+1)*n)}),kl([r],e)}function kl(i,e,t=3){let n=i.filter(l=>l.width>0&&l.height>0);if(!n.length)return;let s=Math.max(...n.map(l=>l.width)),r=Math.max(...n.map(l=>l.height)),o=Math.min(t,n.length),a=document.createElement("canvas");a.width=o*s,a.height=Math.ceil(n.length/o)*r;let c=a.getContext("2d");c.fillStyle=Le("--card"),c.fillRect(0,0,a.width,a.height),n.forEach((l,h)=>c.drawImage(l,h%o*s,Math.floor(h/o)*r)),a.toBlob(l=>l&&Si(l,e))}function Q_(i,e){let t=10**(Math.floor(Math.log10(i))-1);return Number(((e?Math.ceil(i/t):Math.floor(i/t))*t).toPrecision(6))}function ev(i,e){if(i.kind==="count")return 1;if(e!==0)return 10**(Math.floor(Math.log10(Math.abs(e))+1e-9)-2);let t=i.lowest!==null&&i.highest!==null?i.highest-i.lowest:1;return 10**(Math.floor(Math.log10(t))-2)}function Bl(i,e,t){return Math.min(Math.max(i,e),t)}function tv(i,e,t){let n=ev(i,e),s=Math.sign(t),r=e/n,o=s>0?Math.floor(r+1e-6)+1:Math.ceil(r-1e-6)-1,a=Number(((o+s*(Math.abs(t)-1))*n).toPrecision(6));return e!==0&&Math.sign(a)!==Math.sign(e)&&i.lowest!==null&&i.lowest>=0&&(a=Number((e*.99).toPrecision(3))),Bl(a,i.lowest??-1/0,i.highest??1/0)}function pA(i,e){let{lowest:t,highest:n}=i,s=l=>i.kind==="count"?Math.round(l):l;if(e>0&&!(t!==null&&t<0)&&!(n!==null&&n<=1)){let l=Math.max(t??0,s(Q_(e/4,!1)),i.kind==="count"?1:1e-9),h=Math.max(Math.min(n??1/0,s(Q_(e*4,!0))),i.kind==="count"?Math.min(6,n??6):0,l*1.0001),u=Math.log(h/l),d=f=>{let p=ev(i,f);return Number((Math.round(f/p)*p).toPrecision(6))};return{from:l,to:h,value:f=>Bl(d(l*Math.exp(f*u)),l,h),share:f=>Bl(Math.log(Math.max(f,1e-12)/l)/u,0,1)}}let r=t??Math.min(0,2*e),o=n??Math.max(1,2*e),a=(o-r)/200,c=l=>i.kind==="count"?Math.round(l):Number((Math.round(l/a)*a).toPrecision(6));return{from:r,to:o,value:l=>Bl(c(r+l*(o-r)),r,o),share:l=>Bl((l-r)/(o-r||1),0,1)}}function nv(i,e,t){return t&&e>=t.from&&e<=t.to?t:pA(i,e)}function cm(i,e){let t=i.map(n=>Math.abs(Math.log(n/Math.max(e,1e-9))));return t.indexOf(Math.min(...t))}var zl=1e3,mA={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10},Au=class{constructor(e,t){this.place=e;this.set=t}place;set;rows=new Map;dragged="";gestures=0;scales=new Map;sizes={};bought=!0;build(e,t,n){let s=this.place.contains(document.activeElement)?document.activeElement.id:"",r=new Set([...this.place.querySelectorAll("details[open]")].map(l=>l.dataset.group)),o=this.rows.size===0;this.rows.clear(),this.place.replaceChildren(this.choice());let a=new Map;for(let l of e){if(!a.has(l.group)){let u=$("summary",{},Eu(l.group));n.includes(l.group)&&u.append(Vt("remove",()=>this.set(l.group,null),{class:"remove","aria-label":`remove ${l.group}`}));let d=$("details",{"data-group":l.group,"aria-label":Eu(l.group)},u);d.open=o?["resonator","membrane","tube"].includes(l.group):r.has(l.group),a.set(l.group,d),this.place.append(d)}let h=this.row(l);this.rows.set(l.name,h),a.get(l.group).append(h.row)}let c=$("select",{id:"add-table","aria-label":"add a table that the design does not state"},$("option",{value:""},"add a table\u2026"),...Object.keys(t).map(l=>$("option",{value:l},Eu(l))));c.addEventListener("change",()=>{c.value&&this.set(c.value,t[c.value]),c.value=""}),this.place.append($("p",{},c)),s&&document.getElementById(s)?.focus()}choice(){let e=$("input",{type:"checkbox",id:"bought-only"});return e.checked=this.bought,e.addEventListener("change",()=>{this.bought=e.checked;for(let n of this.rows.values())this.sizes[n.field.name]&&n.show(n.field.value)}),$("p",{class:"choice",title:"sliders of tubes and membranes stop at sizes that can be bought, and wire and sheath follow the bore"},e,$("label",{for:"bought-only"},"Parts that can be bought"))}offer(e){let t=this.sizes;this.sizes=e;for(let[n,s]of this.rows)n!==this.dragged&&String(t[n])!==String(e[n])&&s.show(s.field.value)}stops(e){let n=(this.bought?this.sizes[e.name]??[]:[]).filter(s=>s>=(e.lowest??-1/0)&&s<=(e.highest??1/0));return n.length>1?n:null}hint(e,t){let n=new Set(e);for(let[s,{row:r,field:o}]of this.rows){if(r.hidden=n.has(s),!o.optional)continue;let a=t[s],c=r.querySelector(".value"),l=a===void 0?"default":typeof a=="number"?`(${Ue(a)})`:a;c instanceof HTMLSelectElement?c.options[0].textContent=a===void 0?"default":`default: ${a}`:c.setAttribute("placeholder",l)}}update(e){for(let[t,n]of Object.entries(e)){let s=this.rows.get(t);s&&(s.field.value=n,t!==this.dragged&&s.show(n))}}settle(e=""){for(let t of this.place.querySelectorAll(".refused, .concerned")){let n=this.rows.get(t.dataset.name);n&&t.classList.contains("refused")&&![e,this.dragged].includes(n.field.name)&&n.show(n.field.value),t.classList.remove("refused","concerned"),t.querySelector(".refusal")?.replaceChildren(),t.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid")}}refuse(e,t,n,s){this.settle(e);let r=this.rows.get(e);if(!r)return!1;r.row.closest("details").open=!0,r.row.hidden=!1,r.row.classList.add("refused"),r.row.querySelector(".value")?.setAttribute("aria-invalid","true");let o=r.row.querySelector(".refusal");if(o.append($("span",{},t)),n&&!t.includes(n)&&o.append($("span",{},` The field alone: ${n}.`)),s!==null){let c=r.field.unit?` ${r.field.unit}`:"";o.append(Vt(`Set ${Ue(s,6)}${c}`,()=>this.set(e,s),{class:"mend"}))}o.scrollIntoView({block:"nearest"});let a=t.match(/(?:^|: )([a-z_]+(?:\.[\w-]+)+)/);return a&&a[1]!==e&&this.rows.get(a[1])?.row.classList.add("concerned"),!0}focus(e){let t=this.rows.get(e);t&&(t.row.closest("details").open=!0,t.row.scrollIntoView({block:"center"}),t.row.querySelector(".value")?.focus())}row(e){let t=`field-${e.name}`,n=[e.description,e.allowed].filter(Boolean).join("; "),s=$("div",{class:"field","data-name":e.name,title:`${e.name}: ${n}`}),r=$("label",{for:t},e.label);s.append(r);let o=this.control(e,t);return s.append(...o.elements),e.unit&&s.append($("span",{class:"unit"},e.unit)),s.append($("p",{class:"hint",id:`${t}-hint`},n),$("p",{class:"refusal",role:"alert"})),o.elements[0].setAttribute("aria-describedby",`${t}-hint`),o.show(e.value),{field:e,row:s,show:o.show}}control(e,t){if(e.choices.length){let n=$("select",{id:t,class:"value"},...e.choices.map(s=>$("option",{},s)));return n.addEventListener("change",()=>this.set(e.name,n.value)),{elements:[n],show:s=>{n.value=s}}}if(e.suggestions.length&&(e.value===null||e.suggestions.includes(e.value)))return this.known(e,t);if(e.kind==="flag"){let n=$("input",{id:t,class:"value",type:"checkbox"});return n.addEventListener("change",()=>this.set(e.name,n.checked)),{elements:[n],show:s=>{n.checked=s}}}return e.kind==="text"||e.kind==="list"?this.textual(e,t):this.numeric(e,t)}known(e,t){let n=$("select",{id:t,class:"value"},...e.optional?[$("option",{value:""},"default")]:[],...e.suggestions.map(s=>$("option",{},s)));return n.addEventListener("change",()=>this.set(e.name,n.value||null)),{elements:[n],show:s=>{n.value=s??""}}}textual(e,t){let n=$("input",{id:t,class:"value text",type:"text",autocomplete:"off",spellcheck:"false"}),s=e.kind==="list"&&(e.value??[]).some(r=>typeof r=="number");return n.addEventListener("change",()=>{let r=n.value.split(",").map(a=>a.trim()).filter(Boolean),o=n.value===""&&e.optional?null:n.value;this.set(e.name,e.kind==="text"||o===null?o:s?r.map(Number):r)}),{elements:[n],show:r=>{n.dataset.shown=n.value=Array.isArray(r)?r.join(", "):r??""}}}numeric(e,t){let n=$("input",{id:t,class:"value",type:"text",inputmode:"decimal",autocomplete:"off"}),s=$("input",{type:"range",min:"0",max:String(zl),class:"slider","aria-label":`${Eu(e.group)} ${e.label}, slider`}),r=$("datalist",{id:`${t}-sizes`}),o=$("span",{class:"slider-ends","aria-hidden":"true"});s.setAttribute("list",r.id);let a="";n.addEventListener("change",()=>{let h=n.value.replace("\u2212","-").replace(",",".").trim();h===""&&e.optional?this.set(e.name,null):this.set(e.name,h===""||!Number.isFinite(Number(h))?n.value:Number(h))});let c=(h,u)=>{a||(a=`${e.name}-${++this.gestures}-${Date.now()}`),n.value=String(h),s.setAttribute("aria-valuetext",`${h} ${e.unit}`),this.set(e.name,h,a,u)};s.addEventListener("input",()=>{this.dragged=e.name;let h=this.stops(e);c(h?h[Number(s.value)]:this.scales.get(e.name).value(Number(s.value)/zl),h!==null)}),s.addEventListener("change",()=>{a="",this.dragged="",this.rows.get(e.name)?.row.classList.contains("refused")||l(e.value)}),s.addEventListener("keydown",h=>{let u=mA[h.key];if(!u||h.ctrlKey||h.metaKey||h.altKey)return;h.preventDefault(),h.repeat||(a="");let d=Number(n.value),f=this.stops(e);if(!Number.isFinite(d))return;let p=f?f[Math.min(Math.max(cm(f,d)+Math.sign(u),0),f.length-1)]:tv(e,d,u);p!==d&&(s.value=String(f?f.indexOf(p):Math.round(this.scales.get(e.name).share(p)*zl)),c(p,f!==null))}),s.addEventListener("keyup",()=>{a=""});let l=h=>{if(n.dataset.shown=n.value=h==null?"":String(h),s.disabled=typeof h!="number",typeof h!="number")return;let u=this.stops(e);s.max=String(u?u.length-1:zl),s.setAttribute("aria-valuetext",`${h} ${e.unit}`),r.childElementCount!==(u??[]).length&&r.replaceChildren(...(u??[]).map((v,g)=>$("option",{value:String(g)})));let d=nv(e,h,this.scales.get(e.name));this.scales.set(e.name,d);let[f,p]=u?[u[0],u.at(-1)]:[d.from,d.to];o.replaceChildren($("span",{},Ue(f,3)),$("span",{},Ue(p,3))),s.value=String(u?cm(u,h):Math.round(d.share(h)*zl))};return{elements:[n,s,r,o],show:l}}};function Eu(i){return i===""?"array":i.replace(/^lines\.(\d+)/,(e,t)=>`line ${Number(t)+1}`).replaceAll("_"," ").replaceAll(".",": ")}var iv="acoustic-fem-studio",Ru="acoustic-fem-studio-last";function sv(i){try{sessionStorage.setItem(iv,JSON.stringify(i)),i.unsaved?localStorage.setItem(Ru,JSON.stringify(i)):hm()?.session===i.session&&localStorage.removeItem(Ru)}catch{}}function Cu(){return ov(sessionStorage,iv)}function hm(){return ov(localStorage,Ru)}function rv(){try{localStorage.removeItem(Ru)}catch{}}function ov(i,e){try{return JSON.parse(i.getItem(e)??"null")}catch{return null}}async function av(i){let e=new Blob([JSON.stringify(i)]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),n=btoa(String.fromCharCode(...t)).replaceAll("+","-").replaceAll("/","_").replaceAll("=","");return`${location.origin}/#design=${n}`}async function lv(){if(!location.hash.startsWith("#design="))return null;let i=location.hash.slice(8);history.replaceState(null,"","/");let e=Uint8Array.from(atob(i.replaceAll("-","+").replaceAll("_","/")),r=>r.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).pipeThrough(new TextDecoderStream).getReader(),n="";for(let r=await t.read();!r.done;r=await t.read())if(n+=r.value,n.length>262144)throw await t.cancel(),new Error("no design is as long");let s=JSON.parse(n);if(typeof s!="object"||Array.isArray(s))throw new Error("no table");return s}async function pa(i,e,t){let n="The studio does not answer.";try{let s=await fetch(`${i}?${new URLSearchParams(e)}`,{method:"POST",body:t,headers:tc()});if(s.ok)return s;n=`The studio rejected it (${s.status}).`,n=(await s.json()).message}catch{}throw new Error(n)}async function cv(i,e,t){let n={};for(let s of t){let r=new Uint8Array(await s.arrayBuffer()),o="";for(let a=0;a<r.length;a+=32768)o+=String.fromCharCode(...r.subarray(a,a+32768));n[s.name]=btoa(o)}return(await pa(i,e,JSON.stringify(n))).json()}var hv=22,uv=[["point","",i=>String(i.number)],["top-1 accuracy","%",i=>Ue(100*i.named,3)],["hardest to tell from","",i=>String(i.nearest)],["distance","",i=>Ue(i.distance,3)],["level","dB",i=>Ue(i.level,3)],["phase","\xB0",i=>Ue(i.phase,3)],["smallest detectable force","nN",i=>Ue(1e9*i.force,3)]],Pu=class{constructor(e,t,n,s){this.word=e;this.colourOf=t;this.choose=n;this.hover=s;let r=I("confusion");r.addEventListener("pointermove",o=>this.read(o)),r.addEventListener("pointerleave",()=>{I("pointed-cell").textContent="\xA0",this.hover(null)}),r.addEventListener("click",o=>{let a=this.under(o);a&&this.choose(this.now.points[a[0]].number,o.shiftKey)})}word;colourOf;choose;hover;now=null;lit=null;pointed=null;cell=1;get figures(){return this.now?.figures??{}}take(e){this.now=e,this.draw()}light(e){this.lit=e;for(let t of I("points-table").querySelectorAll("tr[data-point]"))t.classList.toggle("lit",t.dataset.point===String(e));this.matrix()}point(e){if(e!==this.pointed){this.pointed=e;for(let t of I("points-table").querySelectorAll("tr[data-point]"))t.classList.toggle("pointed",t.dataset.point===String(e));I("confusion").clientWidth&&this.matrix()}}recolour(){for(let e of I("points-table").querySelectorAll("tr[data-point]"))e.querySelector(".swatch").style.background=this.colourOf(Number(e.dataset.point))}under(e){let t=I("confusion").getBoundingClientRect(),n=this.now?.points.length??0,[s,r]=[e.clientX-t.left,e.clientY-t.top].map(o=>Math.floor((o-hv)/this.cell));return r>=0&&s>=0&&r<n&&s<n?[r,s]:null}read(e){let t=this.under(e),n=this.now;if(!t||!n)return this.hover(null);let[s,r]=t.map(o=>n.points[o].number);I("pointed-cell").textContent=`point ${s} located as ${r}: ${n.confusion[t[0]][t[1]]} of ${n.touches} touches`,this.hover(s)}asBuilt(e){I("as-built").textContent=`Taps and presses on ${e.sensors} as-built sensors, not calibrated: top-1 accuracy ${Ue(100*e.mean,3)} % (${Ue(100*e.interval[0],2)} to ${Ue(100*e.interval[1],2)} %), 5th percentile ${Ue(100*e.worst,3)} %. Multi-sine touches: ${Ue(100*e.multi_sines,3)} %.`}draw(){let e=this.now;I("figures").replaceChildren(...Object.entries(e.figures).map(([r,o])=>{let a=this.word()[r];return $("div",{title:a.definition,"data-figure":r},$("dt",{},a.title),$("dd",{},js(o,a.unit)))})),I("points-fidelity").textContent=`Fidelity ${e.fidelity}.`,I("hardest").textContent=`Hardest to tell apart: ${e.hardest.map(r=>r.join(" and ")).join("; ")}.`;let t=e.overlaps.length?`Cannot be built: ${e.overlaps.join("; ")}${e.mend?`; ${e.mend}`:""}`:"";I("overlaps").textContent=t;let n=$("tr",{},...uv.map(([r,o])=>$("th",{scope:"col"},o?`${r} (${o})`:r))),s=e.points.map(r=>{let o=$("tr",{"data-point":String(r.number),tabindex:"0"},...uv.map(([,,l])=>$("td",{},l(r)))),a=$("span",{class:"swatch"});a.style.background=this.colourOf(r.number),o.firstElementChild.prepend(a);let c=(l=!1)=>this.choose(this.lit===r.number?null:r.number,l);return o.addEventListener("click",l=>c(l.shiftKey)),o.addEventListener("pointerenter",()=>this.hover(r.number)),o.addEventListener("pointerleave",()=>this.hover(null)),o.addEventListener("keydown",l=>{(l.key==="Enter"||l.key===" ")&&(l.preventDefault(),c())}),o});I("points-table").replaceChildren($("thead",{},n),$("tbody",{},...s)),this.light(this.lit)}matrix(){let e=this.now,t=I("confusion");if(!e)return;let n=e.confusion.length,s=this.cell=Math.max(Math.floor(340/n),3),r=hv,o=devicePixelRatio;t.width=t.height=(n*s+r)*o,t.style.width=t.style.height=`${n*s+r}px`;let a=t.getContext("2d");a.scale(o,o),a.font="10px system-ui",a.textAlign="center",a.textBaseline="middle";let c=Math.ceil(n/14);for(let h=0;h<n;h++){a.fillStyle=Le("--ink-soft"),h%c===0&&(a.fillText(String(e.points[h].number),r+(h+.5)*s,r/2),a.fillText(String(e.points[h].number),r/2,r+(h+.5)*s));for(let u=0;u<n;u++){let d=e.confusion[h][u]/e.touches;a.globalAlpha=d===0?.07:.25+.75*Math.sqrt(d),a.fillStyle=d===0?Le("--ink-soft"):h===u?Le("--good"):Le("--bad"),a.fillRect(r+u*s,r+h*s,s-1,s-1),a.globalAlpha=1,s>=24&&d>0&&(a.fillStyle=Le(h===u&&d>.5?"--card":"--ink"),a.fillText(Ue(100*d,2),r+(u+.5)*s,r+(h+.5)*s))}}for(let[h,u]of[[this.pointed,"--ink"],[this.lit,"--accent"]]){let d=e.points.findIndex(f=>f.number===h);d<0||(a.strokeStyle=Le(u),a.lineWidth=2,a.strokeRect(r,r+d*s,n*s-1,s-1))}let l=e.points.filter(h=>h.named<1).length;t.setAttribute("aria-label",`predicted confusion of ${n} points; ${l} of them are not always assigned to the correct point; the table beside has the figures`)}restyle(){this.matrix(),this.recolour()}table(e){if(!this.now)return;let t=["number","named","nearest","distance","level","phase","force","loudest","coverage"];Ji([["point","top-1 accuracy","hardest to tell from","distance","level (dB)","phase (degrees)","smallest detectable force (N)","level at 100 Hz, loudest microphone (dB)","coverage of its area",...this.now.points.map(n=>`assigned to ${n.number}, of ${this.now.touches} touches`)],...this.now.points.map((n,s)=>[...t.map(r=>n[r]),...this.now.confusion[s]])],`${e}-points.csv`)}picture(e){I("confusion").toBlob(t=>t&&Si(t,`${e}-confusion.png`))}};function js(i,e){return e==="N"&&i!==0&&Math.abs(i)<.001?Math.abs(i)<1e-6?`${Ue(1e9*i)} nN`:`${Ue(1e6*i)} \xB5N`:`${Ue(i)}${e&&e!=="1"?` ${bi(e)}`:""}`}var dv=10,Iu=class{constructor(e,t){this.points=e;this.show=t}points;show;mole=null;hit=0;left=0;begun=0;play(){[this.hit,this.left,this.begun]=[0,dv,performance.now()],this.pop()}whack(e){if(this.mole!==null){if(e.includes(this.mole)&&(this.hit+=1),this.left-=1,this.left>0)return this.pop();this.end(`${this.hit} of ${dv} moles hit in ${Ue((performance.now()-this.begun)/1e3,3)} s`)}}check(){this.mole!==null&&this.mole>this.points()&&this.end("the array has other points now")}pop(){let e=this.mole,t=this.points();if(!(t<2)){for(;this.mole===e;)this.mole=1+Math.floor(Math.random()*t);I("score").dataset.mole=String(this.mole),I("score").textContent=`The mole is at point ${this.mole}. Hit: ${this.hit}; still to come: ${this.left}.`,this.show()}}end(e){this.mole=null,delete I("score").dataset.mole,I("score").textContent=`Over: ${e}.`,this.show()}};var um=34,Hl=16,Lu=class{seconds=0;constructor(e){I("timeline").addEventListener("click",t=>{let n=I("timeline").getBoundingClientRect();this.seconds&&e((t.clientX-n.left)/n.width*this.seconds)})}draw(e,t){let n=I("timeline"),s=n.parentElement.clientWidth;if(n.hidden=e===null,!e||!s)return;let r=this.seconds=e.samples/1e3,o=c=>c/r*s;Ei(n,s,um);let a=n.getContext("2d");a.scale(devicePixelRatio,devicePixelRatio),a.fillStyle=Le("--grid"),a.fillRect(0,0,s,Hl),a.font="11px system-ui",a.textBaseline="middle",a.textAlign="center";for(let c of e.paths??[]){if(c.length<=0)continue;a.fillStyle=Le("--good");let[l,h]=[c.places[0][0],c.places.at(-1)[0]];a.fillRect(o(l),Hl,Math.max(o(h-l),2),3)}for(let[c,l,h]of e.touches){let u=o(c),d=Math.max(o(l)-u,2);a.globalAlpha=t!==null&&c>t?.45:1,a.fillStyle=Le("--accent"),a.fillRect(u,0,d,Hl),a.fillStyle=Le("--card"),d>14&&a.fillText(String(h),u+d/2,Hl/2)}a.globalAlpha=1,a.fillStyle=Le("--ink-soft"),a.textAlign="left",a.fillText(t===null?"":`${Ue(Math.round(10*t)/10)} s`,0,um-6),a.textAlign="right",a.fillText(`${Ue(Math.round(10*r)/10)} s`,s,um-6),t!==null&&(a.fillStyle=Le("--ink"),a.fillRect(o(t)-1,0,2,Hl+4)),n.setAttribute("aria-label",`${e.touches.length} touches located within ${Ue(r,3)} s; the line below says which`)}};var ma=1e3,Vl=250,gA=18,fv="Click a membrane to touch it, drag to slide over the array.";function pv(i){let e=1e-9;for(let t of i)for(let n=0;n<t.length;n++)e=Math.max(e,Math.abs(t[n]));return e}var Nu=class{constructor(e,t){this.send=e;this.lit=t;let n=I("plan");n.addEventListener("pointerdown",s=>{this.dragged=this.placeOf(s)}),n.addEventListener("click",s=>{let r=this.dragged,o=this.placeOf(s),a=this.under(s);this.dragged=null,r&&Math.hypot(o[0]-r[0],o[1]-r[1])>2*this.points[0]?.[2]?this.slide(r,o):a&&this.press(a)}),I("game").addEventListener("click",()=>this.game.play()),I("write").addEventListener("click",()=>this.write()),I("touch-kind").addEventListener("change",s=>{for(let r of["letter","write"])I(r).hidden=s.target.value!=="letter"}),new ResizeObserver(()=>this.draw()).observe(n.parentElement)}send;lit;points=[];revision=-1;run=0;counted=0;heard=null;begun=0;now=-1;named=null;queue=[];game=new Iu(()=>this.points.length,()=>this.draw());timeline=new Lu(e=>this.seek(e));again=!1;pictures=0;newly=!1;lightings=[];planned="";shown=null;from=null;dragged=null;live=null;asked=!1;take(e,t){t!==this.revision&&this.forget(),this.revision=t,this.points=e.points,this.game.check(),this.planned="",I("touch-fidelity").textContent=`Fidelity ${e.fidelity}.`,I("touch-points").replaceChildren(...e.points.map((n,s)=>Vt(String(s+1),()=>this.press(s+1),{"aria-label":`touch point ${s+1}`}))),this.draw()}forget(){this.queue=[],this.heard=this.shown=this.from=null,this.name(null),I("answer").textContent=fv;for(let e of["pictures","lit","named"])delete I("answer").dataset[e];I("waves").getContext("2d").clearRect(0,0,1e5,1e5)}failed(){this.heard||(I("answer").textContent=fv)}interrupt(){!this.heard||this.heard.touched!==null||(this.shown=this.heard,this.heard=null,this.name(null))}press(e){let t=I("touch-kind").value,n=this.points[e-1];t==="letter"?this.write():t!=="slide"?(this.interrupt(),I("answer").textContent=`point ${e} is touched\u2026`,this.send({do:"touch",point:e,kind:t})):this.from?this.slide(this.from,n):(this.from=n,I("answer").textContent=`A slide from point ${e} to\u2026 (choose a second one)`)}write(){let e=I("letter").value.toUpperCase();this.interrupt(),I("answer").textContent=`a finger writes ${e}\u2026`,this.send({do:"touch",kind:"letter",letter:e})}slide(e,t){this.from=null,this.interrupt(),I("answer").textContent="a finger slides over the array\u2026",this.send({do:"touch",kind:"slide",start:e.slice(0,2),end:t.slice(0,2)})}hearLive(e){e.samples?(this.live??={names:e.microphones,samples:e.microphones.map(()=>[])},e.samples.forEach((t,n)=>{this.live.samples[n]=[...this.live.samples[n],...t].slice(-ma)}),this.name(e.state==="touch"?e.point:null),I("answer").textContent=this.named?`point ${this.named} (${Ue(100*e.probability,2)} %)`:e.state):(e.fault||e.text)&&(I("answer").textContent=e.text??e.fault),e.event==="up"&&this.game.whack([e.point]),!this.asked&&(this.asked=!0,requestAnimationFrame(()=>{this.asked=!1,this.draw()}))}name(e){return e===this.named?!1:(this.named=e,this.lit(e),!0)}endLive(){this.live=null,this.name(null),this.draw()}hear(e){this.interrupt(),this.queue.push(e),this.heard||this.next()}restyle(){this.draw()}next(){if(this.heard=this.queue.shift()??null,!this.heard)return;this.begun=performance.now(),I("touch-played").textContent=this.said(this.heard),this.pictures=0,this.lightings=[],this.counted=0,this.again=!1;let e=++this.run;requestAnimationFrame(()=>this.frame(e))}frame(e){let t=this.heard;if(!t||e!==this.run)return;let n=t.samples/1e3;this.now=Math.min((performance.now()-this.begun)/1e3,n),this.pictures+=1;let s=null;for(let o of t.decisions)if(o[0]<=this.now)s=o;else break;let r=s&&s[1]==="touch"?s[2]:null;this.newly&&this.lightings.push(Ue(this.now,5)),this.newly=this.name(r)&&r!==null,this.draw(),t.touched===null&&!this.again&&this.count(t),this.now<n?requestAnimationFrame(()=>this.frame(e)):this.finish(t,(performance.now()-this.begun)/1e3)}count(e){for(let[,t,n]of e.touches.slice(this.counted)){if(t>this.now)return;this.counted+=1,this.game.whack([n])}}seek(e){!this.heard&&this.shown&&(this.queue.unshift(this.shown),this.next()),this.begun=performance.now()-1e3*e,this.again=!0}finish(e,t){let n=e.touches.map(([a,c,l,h])=>`point ${l} from ${Ue(a,3)} to ${Ue(c,3)} s (${Ue(100*h,2)} %)`),s=e.touched===null?`${e.kind==="slide"?"A slide":e.kind==="letter"?"A letter":e.kind}: `:`A ${e.kind} on point ${e.touched}; located: `,r=(e.paths??[]).filter(a=>a.length>0).map(a=>`${a.gesture}, ${Ue(a.length,3)} mm`);I("answer").textContent=s+(n.length?n.join(", "):"no touch was detected")+(r.length?`; path: ${r.join("; ")}`:""),e.kinds?I("answer").textContent+=`; recognized: ${e.kinds.map(a=>`${a[3]} (${Ue(100*a[4],2)} %)`).join(", ")||"nothing"}`:e.line&&(I("answer").textContent+="; to recognize the letter, load a recognizer of this array"),I("answer").dataset.pictures=String(Math.round(this.pictures/t)),I("answer").dataset.lit=this.lightings.join(","),I("answer").dataset.named=e.touches.map(a=>a[2]).join(","),e.touched!==null&&!this.again&&this.game.whack(e.touches.map(a=>a[2]));let o=e.touches.at(-1);this.name(o?o[2]:null),this.heard=null,this.shown=e,this.draw(),this.next()}place(e){let t=this.points.map(d=>d[0]),n=this.points.map(d=>d[1]),s=Math.max(...this.points.map(d=>d[2]))*1.4,[r,o,a,c]=[Math.min(...t)-s,Math.max(...t)+s,Math.min(...n)-s,Math.max(...n)+s],l=Math.min(e.width/(o-r),e.height/(c-a)),h=(e.width-l*(o-r))/2,u=(e.height-l*(c-a))/2;return{at:(d,f)=>[h+l*(d-r),e.height-u-l*(f-a)],scale:l}}draw(){this.plan(),this.waves(),this.timeline.draw(this.live?null:this.heard??this.shown,this.heard?this.now:null)}plan(){let e=I("plan"),t=e.parentElement.clientWidth;if(!this.points.length||t===0)return;let n=this.points.map(d=>d[0]),s=this.points.map(d=>d[1]),r=this.live?null:this.heard??this.shown,o=[t,devicePixelRatio,document.documentElement.dataset.theme,this.named,this.game.mole,this.heard?.touched,(r?.paths||r?.line)&&this.now].join();if(o===this.planned)return;this.planned=o;let a=(Math.max(...s)-Math.min(...s)+12)/(Math.max(...n)-Math.min(...n)+12),c=Math.round(Math.min(Math.max(t*a,110),380));Ei(e,t,c);let l=e.getContext("2d"),{at:h,scale:u}=this.place(e);l.textAlign="center",l.textBaseline="middle",this.points.forEach(([d,f,p],v)=>{let[g,m]=h(d,f),y=v+1;l.beginPath(),l.arc(g,m,Math.max(p*u,6*devicePixelRatio),0,7),l.fillStyle=y===this.named?Le("--accent"):Le("--button"),l.fill(),l.lineWidth=(y===this.game.mole?5:1)*devicePixelRatio,l.strokeStyle=y===this.game.mole?Le("--good"):Le("--ink-soft"),l.stroke(),this.heard&&y===this.heard.touched&&(l.beginPath(),l.arc(g,m,Math.max(p*u,6*devicePixelRatio)+5*devicePixelRatio,0,7),l.lineWidth=2*devicePixelRatio,l.strokeStyle=Le("--ink"),l.stroke()),l.fillStyle=y===this.named?Le("--card"):Le("--ink"),l.font=`${Math.max(Math.min(p*u,14*devicePixelRatio),9*devicePixelRatio)}px system-ui`,l.fillText(String(y),g,m)}),this.paths(l,h,u)}waveforms(){if(this.live)return{names:this.live.names,of:n=>this.live.samples[n],until:this.live.samples[0].length,most:pv(this.live.samples)};let e=this.heard??this.shown;if(!e)return null;let t=n=>e.values.subarray(n*e.samples,(n+1)*e.samples);return{names:e.microphones,of:t,until:this.heard?Math.floor(this.now*1e3):e.samples,most:e.most??=pv([e.values])}}paths(e,t,n){let s=this.heard??this.shown;if(!(this.live||!s)){e.fillStyle=Le("--accent");for(let[r,o,a,c]of s.line??[]){if(this.heard&&r>this.now)break;e.globalAlpha=Math.min(c,1);let l=Math.max(n,2*devicePixelRatio),[h,u]=t(o,a);e.fillRect(h-l/2,u-l/2,l,l)}e.globalAlpha=1,e.strokeStyle=e.fillStyle=Le("--accent"),e.lineWidth=3*devicePixelRatio;for(let r of s.paths??[]){let o=r.places.filter(c=>!this.heard||c[0]<=this.now),a=o.at(-1);a&&(r.length>0&&(e.beginPath(),o.forEach(([,c,l,,h],u)=>{h&&u&&o[u-1][4]?e.lineTo(...t(c,l)):e.moveTo(...t(c,l))}),e.stroke()),e.globalAlpha=r.length>0?.25:.4,e.beginPath(),e.arc(...t(a[1],a[2]),Math.max(a[3]*n,4*devicePixelRatio),0,7),e.fill(),e.globalAlpha=1)}}}waves(){let e=I("waves"),t=this.waveforms(),n=e.parentElement.clientWidth;if(!t||n===0)return;let{names:s,of:r,until:o,most:a}=t,c=s.length,l=64;Ei(e,n,l*c+gA);let h=e.getContext("2d"),u=Math.max(0,o-ma),d=e.width/ma,f=l*devicePixelRatio;this.times(h,e.width,l*c*devicePixelRatio,u),h.font=`${12*devicePixelRatio}px system-ui`,s.forEach((p,v)=>{let g=r(v),m=(v+.5)*f;h.strokeStyle=Le("--grid"),h.lineWidth=1,h.beginPath(),h.moveTo(0,m),h.lineTo(e.width,m),h.stroke(),h.strokeStyle=Le("--accent"),h.lineWidth=1.3*devicePixelRatio,h.beginPath();for(let y=u;y<o;y++)h.lineTo((y-u)*d,m-g[y]/a*f*.44);h.stroke(),h.fillStyle=Le("--ink-soft"),h.fillText(`${p}, \xB1${Ue(a,2)} Pa`,6*devicePixelRatio,v*f+14*devicePixelRatio)})}times(e,t,n,s){e.font=`${11*devicePixelRatio}px system-ui`,e.fillStyle=Le("--ink-soft"),e.strokeStyle=Le("--grid"),e.lineWidth=devicePixelRatio;for(let r=Math.ceil(s/Vl)*Vl;r<=s+ma;r+=Vl){let o=(r-s)/ma*t;e.beginPath(),e.moveTo(o,0),e.lineTo(o,n),e.stroke(),e.textAlign=r-s<Vl/4?"left":s+ma-r<Vl/4?"right":"center",e.fillText(`${Ue(r/1e3)} s`,o,n+12*devicePixelRatio)}e.textAlign="left"}said(e){return e.touched===null&&e.kind!=="slide"&&e.kind!=="letter"?`Plays the recording ${e.kind}, ${e.full_scale?`with a full scale of ${Ue(e.full_scale)} Pa`:"which holds pascals"}.`:"Plays the sensor as designed, with the noise of its microphones and without sound of the room."}table(e){let t=this.waveforms(),n=this.live?[]:(this.heard??this.shown)?.decisions??[];if(!t)return;let s=-1,r=Array.from({length:t.until},(o,a)=>{for(;s+1<n.length&&n[s+1][0]<=a/1e3;)s+=1;return[a/1e3,...t.names.map((c,l)=>t.of(l)[a]),s>=0&&n[s][1]==="touch"&&n[s][2]||""]});Ji([["time (s)",...t.names.map(o=>`${o} (Pa)`),"located point"],...r],`${e}-touch.csv`)}picture(e){kl([I("plan"),I("waves")],`${e}-touch.png`,1)}placeOf(e){let t=I("plan"),n=t.getBoundingClientRect(),{at:s,scale:r}=this.place(t),[o,a]=s(0,0),c=(e.clientX-n.left)*(t.width/n.width),l=(e.clientY-n.top)*(t.height/n.height);return[(c-o)/r,(a-l)/r]}under(e){let t=I("plan"),n=t.getBoundingClientRect(),{at:s,scale:r}=this.place(t),o=(e.clientX-n.left)*(t.width/n.width),a=(e.clientY-n.top)*(t.height/n.height),c=null,l=1/0;return this.points.forEach(([h,u,d],f)=>{let[p,v]=s(h,u),g=Math.hypot(p-o,v-a);g<Math.max(d*r,6*devicePixelRatio)*1.3&&g<l&&(l=g,c=f+1)}),c}async sound(){let e=this.heard??this.shown;if(!e)return;let t=8,n=new AudioContext,s=n.createBuffer(Math.min(e.microphones.length,2),e.samples*t,8e3);for(let o=0;o<s.numberOfChannels;o++){let a=e.values.subarray(o*e.samples,(o+1)*e.samples),c=s.getChannelData(o),l=1e-9;for(let h of a)l=Math.max(l,Math.abs(h));for(let h=0;h<c.length;h++){let u=h/t,d=Math.floor(u),f=Math.min(d+1,a.length-1);c[h]=(a[d]+(u-d)*(a[f]-a[d]))/l}}let r=n.createBufferSource();r.buffer=s,r.connect(n.destination),r.onended=()=>n.close(),r.start()}};var mv=3,Du=class{constructor(e,t){this.place=e;this.apply=t}place;apply;outcome="";rows=[];take(e){this.outcome=e.outcome,this.rows=e.rows.map(([s,r])=>[s,_r(r)]),this.place.dataset.outcome=e.outcome.replaceAll(" ","-");let t=e.reasons.slice(0,mv).map(({words:s,remedy:r})=>{let o=$("li",{},`${_r(s)}. `);return r&&o.append(Vt("Fix",()=>this.apply(r.changes),{title:r.line}),$("span",{class:"note"},` ${r.line}`)),o}),n=e.reasons.slice(mv).map(s=>s.rule);n.length&&t.push($("li",{},`also: ${n.join(", ")}`)),t.push(...e.clipped.map(s=>$("li",{class:"note"},_r(s)))),this.place.replaceChildren($("strong",{},e.outcome),$("ul",{},...t),$("dl",{},...e.rows.flatMap(([s,r,o])=>[$("dt",{title:o},s),$("dd",{},_r(r))])))}};var Ou=class{constructor(e,t,n){this.send=e;this.failed=t;this.end=n;I("live").addEventListener("click",()=>this.turn(!this.on)),I("card").addEventListener("change",()=>{this.on&&this.turn(!0)})}send;failed;end;get on(){return I("live").getAttribute("aria-pressed")==="true"}turn(e){if(I("live").setAttribute("aria-pressed",String(e)),document.querySelector("[data-problem='live']").textContent="",!e){this.send({do:"stop",stage:"live"}),this.end();return}let t=I("card");t.hidden?this.send({do:"cards"}):this.send({do:"listen",device:Number(t.value),full_scale:Number(I("full-scale").value)})}cards(e){let t=I("card");t.replaceChildren(...e.map(n=>$("option",{value:String(n.number)},`${n.name}, ${n.channels} channels`))),t.value=String(e.find(n=>n.default)?.number??e[0]?.number??""),t.hidden=e.length===0,e.length?this.turn(!0):this.failed("no device that can record is there")}};function dm(i,e,t){let n=$("canvas",{"aria-hidden":"true"});Ei(n,e,t);let s=n.getContext("2d"),r=[...i.points,...i.microphones.map(([f,p])=>[f,p,2])],[o,a]=[Math.min(...r.map(([f,,p])=>f-p)),Math.max(...r.map(([f,,p])=>f+p))],[c,l]=[Math.min(...r.map(([,f,p])=>f-p)),Math.max(...r.map(([,f,p])=>f+p))],h=.92*Math.min(n.width/(a-o),n.height/(l-c)),u=(f,p)=>[n.width/2+h*(f-(o+a)/2),n.height/2-h*(p-(c+l)/2)];s.strokeStyle=Le("--ink-soft"),s.lineWidth=devicePixelRatio;for(let f of i.lines){s.beginPath();for(let p of f)s.lineTo(...u(i.points[p-1][0],i.points[p-1][1]));s.stroke()}let d=Math.max(i.points.length-1,1);i.points.forEach(([f,p,v],g)=>{s.beginPath(),s.arc(...u(f,p),Math.max(v*h,1.5*devicePixelRatio),0,7),s.fillStyle=Al(g/d),s.fill()}),s.fillStyle=Le("--good");for(let[f,p]of i.microphones){let[v,g]=u(f,p),m=Math.max(2.4*h,4*devicePixelRatio);s.fillRect(v-m/2,g-m/2,m,m)}return n}var gv="acoustic-fem-recent";function fm(){try{return JSON.parse(localStorage.getItem(gv)??"[]")}catch{return[]}}function xv(i){let e=fm().filter(t=>t.name!==i.name);try{localStorage.setItem(gv,JSON.stringify([i,...e].slice(0,6)))}catch{}}var Uu=class{constructor(e,t,n){this.send=e;this.open=t;this.prototype=n;I("new").addEventListener("click",()=>{this.dialogue.showModal(),this.words?this.gallery():this.send({do:"job"})}),I("job-close").addEventListener("click",()=>this.dialogue.close()),I("job-place").addEventListener("change",()=>this.usual()),I("job-stop").addEventListener("click",()=>this.send({do:"stop",stage:"proposals"})),I("job-form").addEventListener("submit",s=>{s.preventDefault(),this.ask()})}send;open;prototype;words=null;dialogue=I("job");learn(e){this.words=e;let t=(r,o,a)=>{I(r).replaceChildren(...o.map(([c,l])=>$("option",{value:c},l))),I(r).value=a};t("job-place",Object.entries(e.places).map(([r,o])=>[r,o.title]),"flat"),t("job-printer",Object.entries(e.printers),e.printer);let[n,s]=e.target.split(" ");t("job-contact",e.contacts.map(r=>[r,r]),n),I("job-force").value=s,this.usual(),this.gallery()}progress(e){I("job-progress").textContent=e,I("job-propose").disabled=e!=="",I("job-stop").disabled=e===""}failed(e){this.progress(""),I("job-problem").textContent=e}take(e){this.progress(""),I("job-problem").textContent=e.problem,I("job-found").replaceChildren(...e.designs.map(t=>this.card(t))),I("job-found").querySelector("button")?.focus()}usual(){let e=this.words.places[I("job-place").value],t={points:String(e.points),microphones:String(e.microphones),size:e.size??"any",around:e.around===null?"flat":String(e.around)};for(let[n,s]of Object.entries(t))I(`job-${n}`).placeholder=s;I("job-around").disabled=e.around===null}ask(){let e=n=>I(`job-${n}`).value.trim(),t={};for(let n of["place","points","size","printer"])e(n)&&(t[n]=e(n));for(let n of["microphones","budget","around"]){if(!e(n)||I(`job-${n}`).disabled)continue;let s=Number(e(n).replace(",","."));t[n]=Number.isFinite(s)?s:e(n)}t.target=`${e("contact")} ${e("force")} N`,I("job-problem").textContent="",I("job-found").replaceChildren(),this.send({do:"propose",name:e("name")||"design",asked:t})&&this.progress("begins")}card(e){let t=`${e.strength}: ${e.outcome}`,n=$("dl",{},...e.rows.flatMap(([o,a,c])=>[$("dt",{title:c},o),$("dd",{},_r(a))])),s=$("ul",{},...e.reasons.map(o=>$("li",{},_r(o)))),r=Vt("Open this design",()=>{this.dialogue.close(),this.open(e.stated,"the proposal")},{class:"pick","aria-label":`open the design that is ${e.strength}`});return $("li",{"data-outcome":e.outcome.replaceAll(" ","-")},$("strong",{},t),dm(e.plan,250,110),$("p",{class:"note"},`${e.points} points`),n,s,r)}gallery(){let e=(s,r,o)=>{let a=Vt("",()=>{this.dialogue.close(),o()},{class:"tile"});return a.append(r,$("span",{},s)),a},t=s=>{let r=$("canvas",{width:"150",height:"84","aria-hidden":"true"}),o=new Image;return o.addEventListener("load",()=>r.getContext("2d").drawImage(o,0,0,150,84)),o.src=s.picture,e(s.name,r,()=>this.open(s.stated,"a recent design"))},n=fm();I("job-recent-title").hidden=n.length===0,I("job-recent").replaceChildren(...n.map(t)),I("job-prototypes").replaceChildren(...Object.entries(this.words.prototypes).map(([s,r])=>e(s,dm(r,150,84),()=>this.prototype(s))))}};var xA=3e3,_A=6e3,vA=1008,Fu=class{constructor(e,t,n,s){this.hello=e;this.text=t;this.binary=n;this.state=s;setInterval(()=>this.watch(),xA),this.open()}hello;text;binary;state;socket=null;asked=0;answered=!0;admitted=!1;tries=0;send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}open(){let e=new WebSocket(`ws://${location.host}/session`);e.binaryType="arraybuffer",this.socket=e,this.answered=!0,this.admitted=!1,e.onopen=()=>{e.send(JSON.stringify({...this.hello(),secret:dd()}))},e.onmessage=t=>{this.admitted||(this.admitted=!0,this.tries=0,this.state("open")),this.answered=!0,typeof t.data=="string"?this.text(JSON.parse(t.data)):this.binary(t.data)},e.onclose=t=>this.lost(e,t.code===vA?"locked":"lost")}watch(){this.socket?.readyState===WebSocket.OPEN&&(this.answered?(this.answered=!1,this.asked=performance.now(),this.send({do:"ping"})):performance.now()-this.asked>_A&&this.lost(this.socket))}lost(e,t="lost"){e===this.socket&&(this.socket=null,e.onclose=e.onmessage=null,e.close(),this.state(t),this.tries+=1,setTimeout(()=>this.again(),Math.min(250*2**this.tries,4e3)))}async again(){try{if((await fetch("/studio.css",{method:"HEAD",cache:"no-store"})).ok)return this.open();this.state("locked")}catch{this.state("gone")}this.tries+=1,setTimeout(()=>this.again(),2e3)}};function _v(i,e){let t=document.querySelector("[data-problem='touch']"),n=document.querySelector("[data-status='touch']"),s=async o=>{t.textContent="";let a=o.find(h=>h.name.endsWith(".toml")),c=o.find(h=>h!==a);try{a&&(I("full-scale").value=String((await(await pa("/manifests",{name:a.name},a)).json()).full_scale))}catch(h){t.textContent=h.message;return}if(!c)return;let l={session:e().session,name:c.name,full_scale:I("full-scale").value};I("answer").textContent="the recording is decoded\u2026";try{let h=Mu(await(await pa("/recordings",l,c)).arrayBuffer());if(h.revision!==e().revision)throw new Error("The design was changed meanwhile: replay the recording again.");i.hear(h)}catch(h){i.failed(),t.textContent=h.message}n.textContent=""},r=async o=>{t.textContent="";try{let a=await cv("/recognizers",{session:e().session},o);I("answer").textContent=`A recognizer of ${a.subject} on ${a.design} recognizes: ${a.labels.join(", ")}.`}catch(a){t.textContent=a.message}};I("replay").addEventListener("change",o=>{let a=o.target,c=[...a.files??[]];c.length&&s(c),a.value=""}),I("recognizer").addEventListener("change",o=>{let a=o.target,c=[...a.files??[]];c.length&&r(c),a.value=""})}var pm=196,yA=60,ku=2,vv=34,bA=30,Sr=3,ga=9,SA={"resonator.cavity_diameter":"diameter of the cavity","resonator.cavity_height":"height of the cavity","resonator.wall_thickness":"wall","resonator.floor_thickness":"floor","membrane.thickness":"thickness of the membrane","membrane.rim_width":"rim of the membrane","tube.inner_diameter":"bore of the tube"},Bu=class{constructor(e){this.set=e;for(let[t,n]of Object.entries(SA)){let s=$("input",{type:"text",class:"dimension",inputmode:"decimal",autocomplete:"off","data-dimension":t,"aria-label":`${n}, mm`,title:`${n}, mm: type another one`});s.addEventListener("change",()=>{let r=s.value.replace("\u2212","-").replace(",",".").trim();this.set(t,r===""||!Number.isFinite(Number(r))?s.value:Number(r))}),s.addEventListener("keydown",r=>{r.key==="Escape"&&(this.draw(),s.blur())}),s.addEventListener("blur",()=>this.draw()),this.inputs.set(t,s),I("section-holder").append(s)}new ResizeObserver(()=>this.draw()).observe(I("section-holder"))}set;stated=null;inUse={};inputs=new Map;take(e,t){this.stated=e,t&&(this.inUse=t),this.draw()}draw(){let e=I("section-holder").clientWidth,t=this.stated;if(!t||e===0)return;let n=I("resonator-section"),{resonator:s,membrane:r,tube:o}=t;Ei(n,e,pm);let a=n.getContext("2d");a.scale(devicePixelRatio,devicePixelRatio);let c=(H,Y)=>Y??Number(this.inUse[`resonator.${H}`]??0),l=s.cavity_diameter/2,h=l+s.wall_thickness,u=s.cavity_height,d=-s.floor_thickness,f=u+r.thickness,p=l+r.rim_width,v=Math.max(h,p),g=Math.min((e-2*yA)/(2*(v+ku)),(pm-vv-bA)/(f-d)),m=H=>e/2+g*H,y=H=>pm-vv-g*(H-d),M=(H,Y,B,ce,Z)=>{a.fillStyle=Z,a.fillRect(m(H),y(ce),g*(B-H),g*(ce-Y))},b=Le("--edge"),R=Le("--card");M(-h,d,h,u,b),this.cavity(a,m,y,l,u,R,c);let A=c("port_height",s.port_height),x=o.inner_diameter/2,E=o.outer_diameter/2;for(let H of[-1,1]){let[Y,B]=[H*h,H*(l-.02*l)].sort((ee,se)=>ee-se);M(Y,A-x,B,A+x,R);let[ce,Z]=[H*(h+ku),H*(l+.4*s.wall_thickness)].sort((ee,se)=>ee-se);M(ce,A-E,Z,A+E,Le("--ink-soft")),M(ce,A-x,Z,A+x,R)}M(-p,u,p,f,Le("--accent")),a.strokeStyle=Le("--ink-soft");let k=y(d)+ga,D=y(f)-ga,L=(H,Y,B)=>yv(a,[[m(H),B,m(Y),B],[m(H),B-Sr,m(H),B+Sr],[m(Y),B-Sr,m(Y),B+Sr]]),G=(H,Y,B)=>yv(a,[[B,y(H),B,y(Y)],[B-Sr,y(H),B+Sr,y(H)],[B-Sr,y(Y),B+Sr,y(Y)]]),W=m(-v)-ga,O=m(v)+ga;L(-l,l,k),L(-h,-l,k),L(l,p,D),G(d,0,W),G(u,f,O),G(0,u,m(.72*l)),G(A-x,A+x,m(h+ku)+ga),this.place("resonator.cavity_diameter",2*l,m(0),k+11),this.place("resonator.wall_thickness",s.wall_thickness,Math.max(m(-(h+l)/2),26),k+11),this.place("membrane.rim_width",r.rim_width,m((l+p)/2),D-10),this.place("resonator.floor_thickness",s.floor_thickness,W-26,y(d/2)),this.place("membrane.thickness",r.thickness,O+26,y((u+f)/2)),this.place("resonator.cavity_height",u,m(.72*l)-26,y(u/2)),this.place("tube.inner_diameter",o.inner_diameter,Math.min(m(h+ku)+ga+26,e-24),y(A)),n.setAttribute("aria-label",`section of a resonator: cavity ${Ue(2*l)} mm wide and ${Ue(u)} mm high, wall ${Ue(s.wall_thickness)} mm, floor ${Ue(s.floor_thickness)} mm, membrane ${Ue(r.thickness)} mm`)}place(e,t,n,s){let r=this.inputs.get(e);document.activeElement!==r&&(r.value=Ue(t)),Object.assign(r.style,{left:`${n-22}px`,top:`${s-9}px`})}cavity(e,t,n,s,r,o,a){let{resonator:c}=this.stated;if(e.fillStyle=o,e.beginPath(),c.shape==="box"){let l=a("box_length",c.box_length)/2,h=r-a("collar_height",c.collar_height);for(let[u,d]of[[-s,r],[-s,h],[-l,h],[-l,0],[l,0],[l,h],[s,h],[s,r]])e.lineTo(t(u),n(d))}else if(c.shape==="dome"){let l=a("dome_depth",c.dome_depth),h=(s*s+l*l)/(2*l);e.lineTo(t(-s),n(r));for(let u=-24;u<=24;u++){let d=s*u/24;e.lineTo(t(d),n(h-Math.sqrt(Math.max(h*h-d*d,0))))}e.lineTo(t(s),n(r))}else for(let[l,h]of[[-s,r],[-s,0],[s,0],[s,r]])e.lineTo(t(l),n(h));e.fill()}};function yv(i,e){i.beginPath();for(let[t,n,s,r]of e)i.moveTo(t,n),i.lineTo(s,r);i.stroke()}function bv(){let i=document.getElementById("shared");if(!i)return null;let e=JSON.parse(i.textContent);for(let t of document.querySelectorAll("[role=tab][data-live]"))t.remove();for(let t of["fields","section-holder"])I(t).inert=!0;return I("made").hidden=!1,I("made").textContent=`to look at only; made on ${e.about.made} with acoustic-fem ${e.about.version}. Save downloads the design file, which a studio opens.`,e}var zu=class{constructor(e,t,n){this.shared=e;this.curves=n;for(let s of e.messages)t(s)}shared;curves;send(e){if(e.do==="want"){let t=Uint8Array.from(atob(this.shared.curves[e.quantity]),n=>n.charCodeAt(0));this.curves(t.buffer)}else if(e.do==="export"&&e.name==="design.toml")Si(new Blob([this.shared.toml],{type:"application/toml"}),`${this.shared.messages.find(t=>t.type==="design").design_name}.toml`);else return!1;return!0}};var MA=["predicted_top1","noise_equivalent_force","coverage","length","cost"],Gl=220,Hu=70,Vu=42,mm=20,wA=9,Gu=class{constructor(e){this.open=e;let t=I("parallel");t.addEventListener("pointermove",n=>{this.point(this.under(n))}),t.addEventListener("pointerleave",()=>this.point(null)),t.addEventListener("click",n=>{let s=this.under(n);s&&this.open(s)}),new ResizeObserver(()=>this.draw()).observe(I("parallel-shown").parentElement)}open;lines=[];now={};word={};chosen=new Set(MA);pointed=null;places=[];learn(e){this.word=e,I("parallel-axes").replaceChildren(...Object.entries(e).map(([t,{title:n,definition:s}])=>{let r=$("input",{type:"checkbox","data-axis":t});return r.checked=this.chosen.has(t),r.addEventListener("change",()=>{r.checked?this.chosen.add(t):this.chosen.delete(t),this.draw()}),$("label",{title:s},r,` ${n}`)}))}take(e,t){this.lines=e,t&&(this.now=t),this.draw()}draw(){let e=Object.keys(this.word).filter(h=>this.chosen.has(h)),t={name:"the design at hand",figures:this.now},n=[...this.lines,t].filter(h=>e.some(u=>Number.isFinite(h.figures[u])));I("parallel-shown").hidden=this.lines.length===0;let s=I("parallel"),r=I("parallel-shown").clientWidth;if(this.places=[],!r||(Ei(s,r,Gl),!e.length))return;let o=s.getContext("2d");o.scale(devicePixelRatio,devicePixelRatio),o.font="11px system-ui",o.textAlign="center";let a=h=>e.length===1?r/2:Hu+h*(r-2*Hu)/(e.length-1),c=e.length===1?r-20:Math.min((r-2*Hu)/(e.length-1),2*Hu)-8,l=e.map((h,u)=>this.axis(o,n,h,a(u),c));for(let h of n){let u=e.map((p,v)=>Number.isFinite(h.figures[p])?[a(v),l[v](h.figures[p])]:null),d=h===t;o.strokeStyle=o.fillStyle=Le(d?"--accent":"--ink-soft"),o.lineWidth=h===this.pointed?4:2,o.beginPath();let f=!1;for(let p of u)p&&f?o.lineTo(...p):p&&o.moveTo(...p),f=p!==null;o.stroke();for(let p of u)p&&(o.beginPath(),o.arc(p[0],p[1],3.5,0,7),o.fill());d||this.places.push({line:h,at:u.filter(p=>p!==null)})}s.setAttribute("aria-label",`${this.lines.length} snapshots over ${e.map(h=>this.word[h].title).join(", ")}; the list above opens them`)}axis(e,t,n,s,r){let{title:o,unit:a,better:c}=this.word[n],l=t.map(p=>p.figures[n]).filter(Number.isFinite),h=Math.min(...l),u=Math.max(...l);h===u&&([h,u]=[h-Math.abs(h||1)/2,u+Math.abs(u||1)/2]);let[d,f]=c==="smaller"?[u,h]:[h,u];return e.strokeStyle=Le("--edge"),e.lineWidth=1,e.beginPath(),e.moveTo(s,Vu),e.lineTo(s,Gl-mm),e.stroke(),e.fillStyle=Le("--ink"),TA(o,r,e).slice(0,2).forEach((p,v)=>e.fillText(p,s,11+12*v,r)),e.fillStyle=Le("--ink-soft"),new Set(l).size===1?e.fillText(js(Number(l[0].toPrecision(3)),a),s,Vu-6,r):l.length&&(e.fillText(js(Number(f.toPrecision(3)),a),s,Vu-6,r),e.fillText(js(Number(d.toPrecision(3)),a),s,Gl-6,r)),p=>Gl-mm-(p-d)/(f-d)*(Gl-mm-Vu)}point(e){if(e===this.pointed)return;this.pointed=e;let t=e&&[...this.chosen].filter(n=>Number.isFinite(e.figures[n])).map(n=>`${this.word[n].title} ${js(e.figures[n],this.word[n].unit)}`);I("parallel-pointed").textContent=t?`${e.name}: ${t.join(", ")}`:"\xA0",this.draw()}under(e){let t=I("parallel").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=null,o=wA;for(let{line:a,at:c}of this.places)for(let l=0;l<c.length;l++){let[h,u]=c[l],[d,f]=c[Math.min(l+1,c.length-1)],p=(d-h)**2+(f-u)**2,v=p?Math.min(Math.max(((n-h)*(d-h)+(s-u)*(f-u))/p,0),1):0,g=Math.hypot(n-h-v*(d-h),s-u-v*(f-u));g<o&&(o=g,r=a)}return r}};function TA(i,e,t){let n=[];for(let s of i.split(" ")){let r=n.at(-1);r!==void 0&&t.measureText(`${r} ${s}`).width<=e?n[n.length-1]=`${r} ${s}`:n.push(s)}return n.length>2?[n[0],n.slice(1).join(" ")]:n}var Sv="acoustic-fem-snapshots",Mv="acoustic-fem project 1",wv=24,Wu=class{constructor(e,t,n){this.open=e;this.pin=t;this.take=n;try{let s=JSON.parse(localStorage.getItem(Sv)??"{}");this.all=s.all??[],I("notes").value=s.notes??""}catch{}I("snapshot").addEventListener("click",()=>this.add(this.take())),I("notes").addEventListener("change",()=>this.keep()),this.draw()}open;pin;take;all=[];parallel=new Gu(e=>this.open(this.all.find(t=>t.name===e.name).stated));save(e,t){let n={kind:Mv,stated:e,pinned:t,snapshots:this.all,notes:I("notes").value};Si(new Blob([JSON.stringify(n)],{type:"application/json"}),`${e.name}.afem.json`)}read(e){let t=null;try{t=JSON.parse(e)}catch{}if(t?.kind!==Mv||typeof t.stated!="object"||!Array.isArray(t.snapshots))throw new Error("This is not a project file of this studio.");return this.all=t.snapshots.slice(0,wv),I("notes").value=String(t.notes??""),this.keep(),this.draw(),t}learn(e){this.parallel.learn(e),this.compare()}figured(e,t){let n=JSON.stringify(e),s=this.all.filter(r=>!r.figures&&JSON.stringify(r.stated)===n);for(let r of s)r.figures=t;s.length&&this.keep(),this.compare(t)}restyle(){this.parallel.draw()}compare(e=null){this.parallel.take(this.all.filter(t=>t.figures).map(t=>({name:t.name,figures:t.figures})),e)}add(e){let t=new Set(this.all.map(s=>s.name)),n=e.name;for(let s=2;t.has(n);s++)n=`${e.name} (${s})`;this.all=[{...e,name:n},...this.all].slice(0,wv),this.keep(),this.draw()}keep(){try{localStorage.setItem(Sv,JSON.stringify({all:this.all,notes:I("notes").value}))}catch{}}draw(){this.compare(),I("snapshots-empty").hidden=this.all.length>0,I("snapshots").replaceChildren(...this.all.map((e,t)=>{let n=$("canvas",{width:"150",height:"84","aria-hidden":"true"}),s=new Image;s.addEventListener("load",()=>n.getContext("2d").drawImage(s,0,0,150,84)),e.picture.startsWith("data:image/")&&(s.src=e.picture);let r=$("input",{type:"text","aria-label":`name of snapshot ${t+1}`});return r.value=e.name,r.addEventListener("change",()=>{e.name=r.value,this.keep(),this.compare()}),$("li",{},n,$("div",{},r,$("p",{class:"note"},[e.outcome,...e.rows.map(([o,a])=>`${o} ${a}`)].filter(Boolean).join(", ")),Vt("Open",()=>this.open(e.stated),{"aria-label":`open ${e.name}`})," ",Vt("Compare",()=>this.pin(e.stated),{"aria-label":`compare with ${e.name}`})," ",Vt("\xD7",()=>{this.all=this.all.filter(o=>o!==e),this.keep(),this.draw()},{"aria-label":`remove ${e.name}`})))}))}};var EA=12,AA=["predicted_top1","volume"],Xu=class{constructor(e,t,n){this.send=e;this.load=t;this.marks=n;I("study-limit-add").addEventListener("change",()=>{let r=I("study-limit-add"),o=r.value;if(r.value="",!o||this.limits.has(o))return;let a=this.marks()[0].value(o);this.limits.set(o,o==="verdict"?"1":typeof a=="number"?String(Number(a.toPrecision(3))):""),this.listLimits(),I("study-limits").querySelector(".study-range:last-child input")?.focus()}),I("study-add").addEventListener("change",()=>{let r=I("study-add"),o=this.fields.find(a=>a.name===r.value);r.value="",o&&this.add(o)}),I("study-run").addEventListener("click",()=>this.ask(!0)),I("study-file").addEventListener("click",()=>this.ask(!1)),I("study-csv").addEventListener("click",()=>this.table()),I("study-png").addEventListener("click",()=>this.now&&kl([...I("study-shown").querySelectorAll("canvas")],`${this.now.title}.png`));for(let r of["study-effect","study-x","study-y"])I(r).addEventListener("change",()=>this.draw());let s=I("study-front");s.addEventListener("click",r=>{let o=this.under(r);o!==null&&this.load(this.now.number[o])}),s.addEventListener("pointermove",r=>{I("study-pointed").textContent=this.said(this.under(r))??this.failure(r)??"\xA0"}),new ResizeObserver(()=>this.draw()).observe(I("study-shown"))}send;load;marks;fields=[];ranges=new Map;now=null;places=[];crosses=[];words={};limits=new Map;learn(e,t,n){I("study-metrics").childElementCount||(I("study-designs").setAttribute("max",String(n)),this.words=e,I("study-limit-add").replaceChildren($("option",{value:""},"add a limit\u2026"),...Object.entries(e).map(([s,r])=>$("option",{value:s,title:r.definition},r.title))),I("study-metrics").replaceChildren(...Array.from({length:t},(s,r)=>{let o=$("select",{"aria-label":`figure of merit ${r+1}`},...r?[$("option",{value:""},"\u2013")]:[],...Object.entries(e).map(([a,c])=>$("option",{value:a,title:c.definition},c.title)));return o.value=AA[r]??"",o})))}take(e){this.fields=e.filter(n=>n.kind==="number"||n.kind==="count"||n.choices.length||n.suggestions.length);let t=new Map;for(let n of this.fields)t.has(n.group)||t.set(n.group,$("optgroup",{label:n.group||"array"})),t.get(n.group).append($("option",{value:n.name},n.label));I("study-add").replaceChildren($("option",{value:""},"add a range\u2026"),...t.values());for(let n of this.ranges.keys())this.fields.some(s=>s.name===n)||this.ranges.delete(n);this.list()}found(e){let t=c=>c&&[c.title,...c.parameters,...c.metrics].map(l=>typeof l=="string"?l:l.name).join(),n=t(this.now)===t(e);this.now=e,I("study-shown").hidden=!1;let s=[...e.parameters,...e.metrics],r=(c,l,h)=>{let u=I(c);n||(u.replaceChildren(...l.map((d,f)=>$("option",{value:String(f)},d.title))),u.value=String(h))};r("study-effect",e.metrics,0),r("study-x",s,e.metrics.length>1?e.parameters.length+1:0),r("study-y",s,e.parameters.length);let o=e.kept.filter(Boolean).length,a=e.failures.reduce((c,[,l])=>c+l,0);I("study-said").textContent=`${e.title}, fidelity ${e.fidelity}: ${e.number.length} designs computed${e.waiting?`, ${e.waiting} not yet: Run goes on`:""}${a?`, ${a} failed (${e.failures.map(([c,l])=>`${l}: ${c}`).join("; ")})`:""}${e.limits.length?`; ${o} keep the limits (${e.limits.join("; ")})`:""}.`,this.draw()}restyle(){this.draw()}add(e){if(this.ranges.has(e.name))return;let t=typeof e.value=="number"?e.value:1,n=e.choices.length?e.choices:e.suggestions,s=r=>{let o=e.kind==="count"?Math.round(t*r):Number((t*r).toPrecision(3));return String(Math.min(Math.max(o,e.lowest??-1/0),e.highest??1/0))};this.ranges.set(e.name,n.length?[n.join(", "),""]:[s(.7),s(1.4)]),this.list(),I("study-ranges").querySelector(".study-range:last-child input")?.focus()}list(){I("study-ranges").replaceChildren(...[...this.ranges].map(([e,t])=>{let n=this.fields.find(c=>c.name===e),s=n.kind==="text",r=(c,l)=>{let h=$("input",{type:"text",class:s?"text":"end","aria-label":`${e}, ${l}`,...s?{}:{inputmode:"decimal"}});return h.value=t[c],h.addEventListener("change",()=>{t[c]=h.value}),h},o=s?[r(0,"values")]:[r(0,"from"),$("span",{},"to"),r(1,"to"),$("span",{class:"unit"},n.unit)],a=Vt("\xD7",()=>{this.ranges.delete(e),this.list()},{"aria-label":`no range for ${e}`});return $("div",{class:"study-range","data-range":e},$("span",{class:"label"},e),...o,a)}))}listLimits(){I("study-limits").replaceChildren(...[...this.limits].map(([e,t])=>{let{title:n,unit:s,better:r,definition:o}=this.words[e],a=`${n} at ${r==="larger"?"least":"most"}`,c=$("input",{type:"text",class:"end","aria-label":a,inputmode:"decimal"});c.value=t,c.addEventListener("change",()=>{this.limits.set(e,c.value)});let l=Vt("\xD7",()=>{this.limits.delete(e),this.listLimits()},{"aria-label":`no limit of ${n}`});return $("div",{class:"study-range","data-limit":e,title:o},$("span",{class:"label"},a),c,$("span",{class:"unit"},s==="1"?"":bi(s)),l)}))}ask(e){let t={},n=r=>{let o=r.replace("\u2212","-").replace(",",".").trim();return o===""||Number.isNaN(Number(o))?r:Number(o)};for(let[r,[o,a]]of this.ranges){let c=this.fields.find(l=>l.name===r).kind==="text";t[r]=c?o.split(",").map(l=>l.trim()).filter(Boolean):[n(o),n(a)]}let s=[...I("study-metrics").querySelectorAll("select")].map(r=>r.value).filter(Boolean);this.send({do:"study",run:e,ranges:t,metrics:[...new Set(s)],search:I("study-kind").value==="search",designs:Number(I("study-designs").value),fidelity:I("study-fidelity").value,limits:Object.fromEntries([...this.limits].map(([r,o])=>[r,n(o)]))})}draw(){let e=this.now,t=I("study-shown").clientWidth;if(!e||t===0)return;let n=Number(I("study-effect").value),s=e.metrics[n],r=Math.min(320,t),o=Fl(e.effects[n].flatMap(a=>[...a.low,...a.high]),s.title,s.unit);I("study-effects").replaceChildren(...e.parameters.map((a,c)=>{let l=e.effects[n][c],h=$("canvas",{role:"img"}),u=`${a.name}: explains ${Ue(100*l.share,2)} % of the variance`;return h.setAttribute("aria-label",`${s.title} over ${u}`),h.dataset.share=String(l.share),this.effect(h,r,l,Fl(a.values,a.title,a.unit,a.labels),o),$("figure",{class:"plot"},h,$("figcaption",{},u))})),this.cloud(t),this.best()}effect(e,t,n,s,r){let{c:o,x:a,y:c}=am(e,t,200,s,r);if(o.fillStyle=o.strokeStyle=Le("--accent"),n.centres.length>1&&!s.labels.length){o.globalAlpha=.18,o.beginPath(),n.centres.forEach((l,h)=>o.lineTo(a(l),c(n.low[h])));for(let l=n.centres.length-1;l>=0;l--)o.lineTo(a(n.centres[l]),c(n.high[l]));o.fill(),o.globalAlpha=1,o.lineWidth=2,o.beginPath(),n.centres.forEach((l,h)=>o.lineTo(a(l),c(n.mean[h]))),o.stroke()}n.centres.forEach((l,h)=>{s.labels.length&&(o.globalAlpha=.18,o.fillRect(a(l)-12,c(n.high[h]),24,c(n.low[h])-c(n.high[h])),o.globalAlpha=1),gm(o,a(l),c(n.mean[h]),3)})}column(e){let t=Number(I(e).value),n=this.now.parameters.length;return t<n?[this.now.parameters[t],-1]:[this.now.metrics[t-n],t-n]}front(){let e=this.now,[,t]=this.column("study-x"),[,n]=this.column("study-y"),s=e.fronts.find(l=>l.first===t&&l.second===n||l.first===n&&l.second===t);if(s)return s.rows;let{values:r,better:o}=e.metrics[n>=0?n:t>=0?t:0],a=o==="smaller"?-1:1,c=-1;return r.forEach((l,h)=>{e.kept[h]&&(c<0||a*l>a*r[c])&&(c=h)}),c<0?[]:[c]}remark(){this.now&&I("study-shown").clientWidth&&this.cloud(I("study-shown").clientWidth)}cloud(e){let t=this.now,[n]=this.column("study-x"),[s]=this.column("study-y"),r=I("study-front"),o=(M,b)=>{let R=M.value(b.name),A=typeof R=="string"?b.labels.indexOf(R):R;return typeof A=="number"&&A>=0?A:null},a=this.marks().map(M=>({title:M.title,x:o(M,n),y:o(M,s)})).filter(M=>M.x!==null&&M.y!==null),[c,l]=[n,s].map(M=>t.parameters.indexOf(M)),h=c<0&&l<0?[]:t.failed,u=(M,b)=>b<0?null:M.values[b],d=M=>M!==null,f=Fl([...n.values,...a.map(M=>M.x),...h.map(M=>u(M,c)).filter(d)],n.title,n.unit,n.labels),p=Fl([...s.values,...a.map(M=>M.y),...h.map(M=>u(M,l)).filter(d)],s.title,s.unit,s.labels),{c:v,x:g,y:m}=am(r,Math.min(e,640),340,f,p),y=new Set(this.front());this.places=n.values.map((M,b)=>({row:b,x:g(M),y:m(s.values[b])})),v.fillStyle=v.strokeStyle=Le("--ink-soft");for(let M of this.places)y.has(M.row)||(v.globalAlpha=t.kept[M.row]?.5:.35,gm(v,M.x,M.y,2.5,t.kept[M.row]));v.globalAlpha=1,v.strokeStyle=Le("--bad"),v.lineWidth=1.2,this.crosses=h.map(M=>({failed:M,x:g(u(M,c)??f.low),y:m(u(M,l)??p.low)}));for(let M of this.crosses)RA(v,M.x,M.y,3.5);v.fillStyle=Le("--accent");for(let M of this.places)y.has(M.row)&&gm(v,M.x,M.y,5);v.lineWidth=2,v.font="11px system-ui",v.textBaseline="middle";for(let M of a){let[b,R]=[g(M.x),m(M.y)],A=b>r.clientWidth-90;v.strokeStyle=v.fillStyle=Le("--ink"),v.strokeRect(b-5,R-5,10,10),v.textAlign=A?"right":"left",v.fillText(M.title,b+(A?-9:9),R)}r.dataset.marks=a.map(M=>M.title).join(", "),r.dataset.crosses=String(this.crosses.length),r.setAttribute("aria-label",`${n.values.length} designs, ${s.title} over ${n.title}; ${y.size} on the front, which the table beside lists${this.crosses.length?`; ${this.crosses.length} without figures`:""}`)}best(){let e=this.now,[,t]=this.column("study-y"),n=e.metrics[t>=0?t:0],s=n.better==="smaller"?1:-1,r=[...this.front()].sort((c,l)=>s*(n.values[c]-n.values[l])),o=[...e.metrics,...e.parameters],a=$("tr",{},$("th",{scope:"col"},"design"),...o.map(c=>$("th",{scope:"col"},c.title)));I("study-best").replaceChildren($("thead",{},a),$("tbody",{},...r.slice(0,EA).map(c=>$("tr",{"data-design":String(e.number[c])},$("td",{},Vt(`${e.number[c]}`,()=>this.load(e.number[c]),{"aria-label":`load design ${e.number[c]}`})),...o.map(l=>$("td",{},l.labels[l.values[c]]??js(l.values[c],l.unit)))))))}under(e){let t=I("study-front").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=null,o=12;for(let a of this.places){let c=Math.hypot(a.x-n,a.y-s);c<o&&(o=c,r=a.row)}return r}failure(e){let t=I("study-front").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=this.crosses.find(o=>Math.hypot(o.x-n,o.y-s)<8);return r?`design ${r.failed.number}: ${r.failed.reason}`:null}said(e){if(e===null)return null;let t=[...this.now.metrics,...this.now.parameters];return`design ${this.now.number[e]}: ${t.map(n=>`${n.title} ${n.labels[n.values[e]]??js(n.values[e],n.unit)}`).join(", ")}`}table(){let e=this.now;if(!e)return;let t=[...e.parameters,...e.metrics];Ji([["design",...t.map(n=>n.unit?`${n.name} (${n.unit})`:n.name)],...e.number.map((n,s)=>[n,...t.map(r=>r.labels[r.values[s]]??r.values[s])])],`${e.title}.csv`)}};function gm(i,e,t,n,s=!0){i.beginPath(),i.arc(e,t,n,0,7),s?i.fill():i.stroke()}function RA(i,e,t,n){i.beginPath();for(let s of[-1,1])i.moveTo(e-n,t-s*n),i.lineTo(e+n,t+s*n);i.stroke()}var Tv="acoustic-fem-panel",qu=class{tabs=[...document.querySelectorAll("[role=tab]")];constructor(){for(let t of this.tabs)t.addEventListener("click",()=>this.open(t.id.slice(4)));I("tab-design").parentElement.addEventListener("keydown",t=>this.key(t));let e=null;try{e=sessionStorage.getItem(Tv)}catch{}e&&document.getElementById(`tab-${e}`)&&this.open(e)}open(e){for(let t of this.tabs){let n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1,I(t.getAttribute("aria-controls")).hidden=!n}document.body.dataset.panel=e;try{sessionStorage.setItem(Tv,e)}catch{}}key(e){let t={ArrowDown:1,ArrowRight:1,ArrowUp:-1,ArrowLeft:-1}[e.key];if(!t)return;e.preventDefault();let n=this.tabs.findIndex(r=>r.getAttribute("aria-selected")==="true"),s=this.tabs[(n+t+this.tabs.length)%this.tabs.length];this.open(s.id.slice(4)),s.focus()}};var CA=3e5,PA={open:"",lost:"The connection to the studio was lost and is being restored. The design is kept.",gone:"The studio does not answer: it has ended. Start it again with \u201Cacoustic-fem studio\u201D. This page keeps the design and continues with it.",locked:"The studio does not know this browser. Open the address that it printed last in this browser, then this page continues with its design."},va=bv();va||Jm();var Zu=null,Ai=null,Vn="design",Xl=!1,Hi=-1,xm={},Ju="level",Mr=[],_a=null,Nv=-1e4,Ev=250,to=Cu()?.pinned??null,IA=crypto.getRandomValues(new Uint32Array(4)).join("-"),wr=null,Yu=null,Ku=null,ql=null,xa=new Au(I("fields"),(i,e,t,n)=>An({do:"set",name:i,value:e,gesture:t,bought:n})),Tr=new ru(Ov),Qu=new su(Tr),Mm=i=>Tr.of(i),is=new Su(I("plots"),()=>xm,Mm,Em,Rm),ui=new nu(I("space"),Mm,Em,Rm,va?null:{drag:An,resize:(i,e)=>An({do:"resize",size:i,value:e})}),_m={},ws=new Pu(()=>_m,Mm,Em,Rm),wm=new iu((i,e)=>{ui.light(t=>t.part===i,[{part:i,place:e}]),I("space").scrollIntoView({block:"nearest"})});new qu;var ju=new Uu(i=>Fn?.send(i)??!1,(i,e)=>An({do:"restore",values:i,source:e}),i=>An({do:"prototype",name:i})),vm=new Du(I("verdict-shown"),i=>An({do:"remedy",values:i})),$l=new ou,Vi=new Nu(i=>{document.querySelector("[data-problem='touch']").textContent="",Fn?.send(i)},i=>ui.touch(i)),ym=new Ou(i=>Fn?.send(i),i=>ed({stage:"live",message:i}),()=>Vi.endLive());_v(Vi,()=>({session:Zu??"",revision:Hi}));var ya=new Xu(i=>{document.querySelector("[data-problem='study']").textContent="",Fn?.send(i)},i=>An({do:"load",number:i}),()=>[{title:"this design",value:i=>(ns.points===Hi?ws.figures[i]:void 0)??Iv(Ai,i)},...to?[{title:"pinned",value:i=>$l.pinned(i)??Iv(to,i)}]:[]]),Tm=new Bu((i,e)=>An({do:"set",name:i,value:e})),Yl=new Wu(i=>An({do:"restore",values:i,source:"the snapshot"}),i=>Fn?.send({do:"pin",values:i}),()=>({name:Vn,stated:Ai,picture:ui.thumbnail(),outcome:ns.verdict===Hi?vm.outcome:"",rows:ns.verdict===Hi?vm.rows:[],figures:ns.points===Hi?ws.figures:void 0})),ns={},$u=new Set,bm=new Set;function An(i){if(Nv=performance.now(),JSON.stringify(i).length>CA)return zi("This text is too long for a design.");let e=Mr.at(-1);i.gesture&&i.gesture===e?.gesture?Mr[Mr.length-1]=i:Mr.push(i),Dv()}function Dv(){!_a&&Mr.length&&Fn?.send(Mr[0])&&(_a=Mr.shift())}function Wl(){_a=null,Dv()}function Em(i,e){e&&wr!==null&&i!==wr?Am(i):Cm(i)}function Am(i){Yu=i,I("other").value=i===null?"":String(i),is.light(wr,Yu)}function Rm(i){i!==Ku&&(Ku=i,is.point(i),ui.point(i),ws.point(i),Qu.show(i??wr))}function Ov(){is.repaint(),ui.recolour(),ws.recolour(),Qu.redraw(),kv()}function Cm(i){wr=i,(i===null||i===Yu)&&Am(null),I("point").value=i===null?"":String(i),Qu.show(Ku??i),is.light(i,Yu),ws.light(i),ui.light(e=>i!==null&&e.group===`point ${i}`&&e.kind!=="sheath"&&e.kind!=="spring")}function Uv(i){switch(i.type){case"words":return OA(i);case"design":return FA(i);case"refused":return xa.refuse(i.name,i.message,i.allowed,i.mend)||zi(i.message),Tm.draw(),Wl();case"refused-design":return zi(i.message),Wl();case"error":return zi(i.message),Wl();case"moved":return ui.follow(i),Kl();case"refused-size":return LA(i),Wl();case"progress":return ba(i.stage,i.line||document.querySelector(`[data-status="${i.stage}"]`)?.dataset.said||"computing\u2026");case"failed":return ed(i);case"figures":return void DA(i);case"pinned":return to=i.stated,Fv();case"comparison":I("pin").setAttribute("aria-pressed",String(i.pinned!==null)),i.pinned===null&&is.unpin(),$l.take(i);return;case"compared":return $l.figures(i.rows),ya.remark();case"file":i.stage==="export"&&zv(""),bp(i.file);return;case"validity":I("validity-reason").textContent=i.reason,I("solve").hidden=!i.solves;return;case"solved":return ba("solve","");case"heard":ym.on&&Vi.hearLive(i.event);return;case"job":return ju.learn(i);case"proposals":return ju.take(i);case"cards":return ym.cards(i.cards);case"refused-export":zi(i.message)}}function LA({size:i,message:e,nearest:t}){ui.refuseSize(i);let n=t===null?[]:[Vt(`Set ${Ue(t)} mm`,()=>An({do:"resize",size:i,value:t}),{class:"mend"})];I("size-refusal").replaceChildren($("span",{},e),...n)}function ba(i,e){if(i==="proposals")return ju.progress(e);let t=document.querySelector(`[data-status="${i}"]`);t&&(t.textContent=e),i==="solve"&&(I("solve").textContent=e?"Stop":"Solve in 3-D"),i==="study"&&(I("study-run").disabled=e!=="",I("study-stop").disabled=e==="")}function ed(i){if(i.stage==="proposals")return ju.failed(i.message);ba(i.stage,""),i.stage==="touch"&&Vi.failed();let e=i.stage==="curves"?I("curves-note"):document.querySelector(`[data-problem="${i.stage}"]`);e?e.textContent=i.message:zi(i.message),i.stage==="export"?zv(i.message):i.stage==="live"?(I("live").setAttribute("aria-pressed","false"),Vi.endLive()):ns[i.stage]=-1,Kl()}function Av(){Tr.isByFigure?Ov():Qu.redraw()}async function NA(){for(;performance.now()-Nv<Ev||ui.isDragged;)await new Promise(i=>setTimeout(i,Ev/2))}var Rv=Promise.resolve();async function DA(i){let{stage:e,found:t}=i;if(i.revision<(ns[e]??-1))return;if(e==="model"){let s=Rv.then(NA).then(()=>ui.take(t,i.revision));Rv=s.catch(()=>{});try{await s,kA()}catch{return ed({stage:e,message:"The array could not be fetched from the studio. Change the design to draw it again."})}}if(e==="points"&&(Tr.take(t),ws.take(t),Av(),i.revision===Hi&&Yl.figured(Ai,t.figures),ya.remark()),e==="as_built"&&(Tr.asBuilt(t),ws.asBuilt(t),Av()),e==="verdict"&&vm.take(t),e==="check"&&wm.take(t),e==="surface"&&Vi.take(t,i.revision),e==="study"&&ya.found(t),i.running)return;ns[e]=i.revision,ba(e,"");let n=document.querySelector(`[data-problem="${e}"]`);n&&(n.textContent=""),document.documentElement.dataset[`shown_${e}`]=String(i.revision),Kl()}function OA(i){xm=i.curves;let e=I("quantity");e.replaceChildren(...Object.entries(xm).map(([n,s])=>$("option",{value:n},s))),e.value=Ju,I("prototypes").replaceChildren($("option",{value:""},"prototypes\u2026"),...i.prototypes.map(n=>$("option",{},n))),_m=i.figures,Yl.learn(_m),i.new&&UA(),ya.learn(i.metrics,i.most_metrics,i.most_designs),I("exports").replaceChildren(...Object.entries(i.exports).map(([n,s])=>$("li",{},Vt(n,()=>Bv(n),{"data-export":n}),$("span",{},` ${s.title}; ${s.takes}`))));let t=i.new&&!Cu()?hm():null;t&&!ql&&zA(t),ql=null,td()}function UA(){for(let i of Object.keys(ns))delete ns[i];is.outdate(),ym.on&&ed({stage:"live",message:"The studio was started again: press Live to listen."}),to&&Fn?.send({do:"pin",values:to})}function FA(i){if(Zu=i.session,Hi=i.revision,Xl=i.unsaved,i.form)Ai=i.stated,Vn=i.design_name,xa.build(i.form,i.addable,i.removable),Lv(i.form),ya.take(i.form);else{xa.settle(),xa.update(i.values);for(let[e,t]of Object.entries(i.values))BA(Ai,e,t);"name"in i.values&&(Vn=i.values.name),Object.keys(i.values).some(e=>e.endsWith(".points"))&&Lv(null)}I("size-refusal").replaceChildren(),xa.offer(i.sizes),i.hints&&xa.hint(i.hints.without_effect,i.hints.in_use),Tm.take(Ai,i.hints?.in_use??null),I("name").textContent=Vn,I("unsaved").hidden=!Xl,document.title=`${Xl?"\u25CF ":""}${Vn} \u2013 acoustic-fem studio`,I("undo").disabled=!i.undo,I("redo").disabled=!i.redo,document.documentElement.dataset.revision=String(Hi),Fv(),Kl(),Wl()}var Cv=0;function kA(){va||(clearTimeout(Cv),Cv=window.setTimeout(()=>{ns.model===Hi&&xv({name:Vn,stated:Ai,picture:ui.thumbnail()})},1e3))}var Pv=0;function Fv(){va||(clearTimeout(Pv),Pv=window.setTimeout(()=>sv({session:Zu,stated:Ai,unsaved:Xl,pinned:to}),150))}function Iv(i,e){for(let t of e.split("."))i=i?.[t];return i}function BA(i,e,t){let n=e.split("."),s=n.pop();for(let r of n)if(i=i?.[r],i==null)return;i[s]=t}function Lv(i){let e=(Ai?.lines??[]).reduce((n,s)=>n+s.points,0),t=I("point");(t.options.length!==e+1||i)&&(t.replaceChildren($("option",{value:""},"all points"),...Array.from({length:e},(n,s)=>$("option",{value:String(s+1)},`point ${s+1}`))),I("other").replaceChildren($("option",{value:""},"\u2013"),...[...t.options].slice(1).map(n=>n.cloneNode(!0))),Tr.size(e),Ku=null,Cm(wr!==null&&wr<=e?wr:null))}function Kl(){Sp(I("plots"),is.revision!==Hi);for(let[i,e]of[["model","space"],["points","points-shown"],["points","compared-figures"],["points","point-card"],["as_built","as-built-shown"],["verdict","verdict-shown"],["check","print-shown"],["surface","touch-shown"]])Sp(I(e),ns[i]!==Hi&&!(i==="model"&&ui.isMoved))}function kv(){$u.clear();for(let i of bm)for(let e of i.dataset.stage.split(" "))$u.add(e);Tr.wantsBuilt&&$u.add("as_built"),td()}function td(){Fn?.send({do:"want",stages:[...$u],quantity:Ju})}function zi(i,...e){I("notice").replaceChildren($("span",{},i),...e,Vt("\xD7",()=>{I("notice").hidden=!0},{"aria-label":"close"})),I("notice").hidden=!1}function zA(i){zi(`\u201C${i.stated?.name}\u201D was not saved when its page was closed.`,Vt("Go on with it",()=>{An({do:"restore",values:i.stated,source:"the design that was kept"}),I("notice").hidden=!0}),Vt("Forget it",()=>{rv(),I("notice").hidden=!0}))}function Pm(i){document.documentElement.dataset.theme=i,gx(),Tr.legend(),Tm.draw(),I("theme").setAttribute("aria-pressed",String(i==="dark")),is.restyle(),ui.restyle(),ws.restyle(),Vi.restyle(),ya.restyle(),Yl.restyle()}async function HA(i){try{if(i.name.endsWith(".json")){let{stated:t,pinned:n}=Yl.read(await i.text());An({do:"restore",values:t,source:[...i.name].slice(0,100).join(""),saved:!0}),n&&Fn?.send({do:"pin",values:n});return}let e=await(await pa("/designs",{name:i.name},i)).json();An({do:"restore",values:e,source:[...i.name].slice(0,100).join(""),saved:!0})}catch(e){zi(e.message)}}function Im(){Fn?.send({do:"export",name:"design.toml"})||zi("The studio does not answer, so nothing was saved yet. This page keeps the design.")}function Bv(i){if(i==="design.toml")return Im();I("stop-export").disabled=!1,document.querySelector("[data-problem='export']").textContent="",Fn?.send({do:"export",name:i,fidelity:I("fidelity").value})}function zv(i){I("stop-export").disabled=!0,ba("export",""),document.querySelector("[data-problem='export']").textContent=i}function Hv(i){let e=Mu(i);if(e.stage==="touch"){e.revision===Hi?Vi.hear(e):Vi.failed();return}e.quantity===Ju&&(is.take(e),I("curves-note").textContent="",Kl())}var Fn=null,VA=()=>new Fu(()=>{let i=ql?{session:null,stated:ql,unsaved:!0}:Ai?{session:Zu,stated:Ai,unsaved:Xl}:Cu();return["set","restore","prototype","load"].includes(_a?.do)&&Mr.unshift(_a),_a=null,{do:"hello",page:IA,session:i?.session??null,values:i?.stated??null,saved:i?!i.unsaved:!1}},Uv,Hv,i=>{I("lost").hidden=i==="open",I("lost").textContent=PA[i],document.body.classList.toggle("away",i!=="open")});I("undo").addEventListener("click",()=>An({do:"undo"}));I("redo").addEventListener("click",()=>An({do:"redo"}));I("save").addEventListener("click",Im);I("project").addEventListener("click",()=>Yl.save(Ai,to));I("pin").addEventListener("click",()=>Fn?.send({do:"pin",on:I("pin").getAttribute("aria-pressed")!=="true"}));I("address").addEventListener("click",async()=>{let i=await av(Ai);try{await navigator.clipboard.writeText(i),zi("The address of this design was copied. It opens in a browser that has opened this studio before.")}catch{zi(i)}});I("theme").addEventListener("click",()=>{let i=document.documentElement.dataset.theme==="dark"?"light":"dark";localStorage.setItem("acoustic-fem-theme",i),Pm(i)});I("quantity").addEventListener("change",i=>{Ju=i.target.value,td()});I("point").addEventListener("change",i=>{let e=i.target.value;Cm(e?Number(e):null)});I("other").addEventListener("change",i=>Am(Number(i.target.value)||null));I("prototypes").addEventListener("change",i=>{let e=i.target;e.value&&An({do:"prototype",name:e.value}),e.value=""});I("open").addEventListener("change",i=>{let e=i.target.files?.[0];e&&HA(e),i.target.value=""});I("curves-csv").addEventListener("click",()=>is.table(Vn));I("curves-png").addEventListener("click",()=>is.picture(Vn));document.addEventListener("keydown",i=>{if(!(i.ctrlKey||i.metaKey)||i.altKey)return;let e=i.key.toLowerCase(),t=i.target instanceof HTMLInputElement&&i.target.type==="text"&&i.target.value!==i.target.dataset.shown;if(e==="s")i.preventDefault(),Im();else{if(t)return;e==="z"&&!i.shiftKey?(i.preventDefault(),An({do:"undo"})):(e==="y"||e==="z"&&i.shiftKey)&&(i.preventDefault(),An({do:"redo"}))}});async function Vv(){try{return await lv()}catch{return zi("The address does not hold a readable design. It may have been cut off."),null}}window.addEventListener("hashchange",async()=>{let i=await Vv();i&&An({do:"restore",values:i,source:"the address"})});var Sm=matchMedia("(prefers-color-scheme: dark)");Pm(localStorage.getItem("acoustic-fem-theme")??(Sm.matches?"dark":"light"));Sm.addEventListener("change",()=>{localStorage.getItem("acoustic-fem-theme")||Pm(Sm.matches?"dark":"light")});I("points-png").addEventListener("click",()=>ws.picture(Vn));I("points-csv").addEventListener("click",()=>ws.table(Vn));I("print-png").addEventListener("click",()=>lm(wm.rows(),`${Vn}-print.png`));I("print-csv").addEventListener("click",()=>Ji(wm.rows(),`${Vn}-print.csv`));I("compare-page").addEventListener("click",()=>Bv("comparison.html"));I("compare-png").addEventListener("click",()=>lm($l.rows(),`${Vn}-compare.png`));I("compare-csv").addEventListener("click",()=>Ji($l.rows(),`${Vn}-compare.csv`));I("stop-check").addEventListener("click",()=>{Fn?.send({do:"stop",stage:"check"}),ba("check","stopped")});I("stop-export").addEventListener("click",()=>Fn?.send({do:"stop",stage:"export"}));I("study-stop").addEventListener("click",()=>Fn?.send({do:"stop",stage:"study"}));I("solve").addEventListener("click",()=>{document.querySelector("[data-problem='solve']").textContent="",Fn?.send(I("solve").textContent==="Stop"?{do:"stop",stage:"solve"}:{do:"solve"})});I("sound").addEventListener("click",()=>Vi.sound());I("touch-png").addEventListener("click",()=>Vi.picture(Vn));I("touch-csv").addEventListener("click",()=>Vi.table(Vn));for(let i of document.querySelectorAll("main section, aside section"))for(let e of i.querySelectorAll("button[id$='-png'], button[id$='-csv'], button[id^='stop-']"))e.setAttribute("aria-label",`${e.textContent}, ${i.querySelector("h2").textContent}`);I("array-png").addEventListener("click",()=>ui.picture(Vn));var GA=new IntersectionObserver(i=>{for(let e of i)e.isIntersecting?bm.add(e.target):bm.delete(e.target);kv()},{rootMargin:"100px"});for(let i of document.querySelectorAll("[data-stage]"))GA.observe(i);(async()=>{if(va)return Fn=new zu(va,Uv,Hv),td();ql=await Vv(),Fn=VA()})();})();
