#lang racket/base
;; A system as a folder of C: its rates and their derivatives, the method of Dormand and
;; Prince, ensembles on all cores, a program for the command line, and how to build them.
;;
;; Code that is the same for all systems is in the folder C/ here; the rest is written below.

(require racket/file
         racket/list
         racket/runtime-path
         racket/string
         "exported-system.rkt" "method-text.rkt" "variable-names.rkt" "program-text.rkt"
         "template.rkt"
         "../../compile/program.rkt"
         (only-in "../../numeric/ode/dormand-prince-853.rkt" dormand-prince-853-formulas)
         "../../operation/operation-column.rkt")

(provide C-files)

(define-runtime-path C-folder "C")

;; -> alist of names of files and their texts
(define (C-files who s)
  (define name (exported-name s))
  (define (fixed file) (cons file (file->string (build-path C-folder file))))
  (define (filled file as [words (settings s)])
    (cons as (fill-template (build-path C-folder file) words)))
  (list (fixed "dop853.h")
        (filled "dop853.c" "dop853.c" (C-method-texts dormand-prince-853-formulas C))
        (filled "system.h" (string-append name ".h"))
        (cons (string-append name ".c") (system-source who s))
        (filled "ensemble.c" (string-append name "_ensemble.c"))
        (filled "main.c" "main.c")
        (filled "Makefile" "Makefile")
        (filled "README.md" "README.md")))

(define (settings s)
  (define parameters (exported-parameters s))
  (hash "NAME" (exported-name s)
        "GUARD" (string-upcase (exported-name s))
        "DEFINITION" (safe-comment (exported-definition s))
        "SIZE" (number->string (exported-size s))
        "PARAMETERS" (number->string (exported-parameter-count s))
        "CLOCK" (if (exported-clock? s) "0" "-1")
        "VARIABLES" (numbered "y" (exported-variables s))
        "PARAMETER_LIST" (numbered "p" parameters)
        "VARIABLE_NAMES" (quoted (exported-variables s))
        "PARAMETER_NAMES" (if (null? parameters) "\"\"" (quoted parameters))
        "JACOBIAN" (if (exported-jacobian s) (jacobian-declaration (exported-name s)) "")
        "EXAMPLE" (string-join (for/list ([_ (in-list (exported-variables s))]) "0.1") " ")
        "EXAMPLE_PARAMETERS" (string-join (for/list ([_ (in-list parameters)]) "1.0") " ")))

(define (jacobian-declaration name)
  (format
   #<<text

/* The derivatives of the rates by the variables, then by the parameters: J has a row of
   ~a_size + ~a_parameters numbers for each rate. */
void ~a_jacobian(const double *y, const double *p, double *J);

text
   name name name))

(define (numbered letter names)
  (define all
    (for/list ([x (in-list names)] [k (in-naturals)])
      (format "~a[~a] = ~a" letter k (safe-comment (symbol->string x)))))
  (if (null? all) "none" (string-join all ", ")))

(define (quoted names)
  (string-join (for/list ([x (in-list names)]) (format "~s" (format "~a" x))) ", "))

;; The user's text must not end a comment.
(define (safe-comment text) (string-replace (string-replace text "*/" "* /") "\n" " "))

;; ---------------------------------------------------------------------------
;; The system

(define (system-source who s)
  (define name (exported-name s))
  (define programs (filter values (list (exported-slope s) (exported-jacobian s))))
  (define used (remove-duplicates (append-map helpers-of programs) eq?))
  (string-append
   (format "/* ~a\n\n   variables: ~a\n   parameters: ~a */\n\n"
           (safe-comment (exported-definition s))
           (numbered "y" (exported-variables s))
           (numbered "p" (exported-parameters s)))
   (format "#include \"~a.h\"\n\n#include <math.h>\n" name)
   (helpers used)
   (C-function who s "derivative" "dy" (exported-slope s))
   (if (exported-jacobian s) (C-function who s "jacobian" "J" (exported-jacobian s)) "")))

(define (helpers-of p)
  (append* (for/list ([i (in-vector (program-instructions p))])
             (define operation (instruction-operation i))
             (cond [(not (eq? operation 'solve)) (list operation)]
                   [(symmetric-system? i) '(solve solve_symmetric)]
                   [else '(solve)]))))

(define (helpers used)
  (apply string-append
         (for/list ([h (in-list '(solve solve_symmetric wrapped sgn))] #:when (memq h used))
           (string-append "\n" (file->string (build-path C-folder (format "~a.c" h)))))))

(define (C-function who s suffix output p)
  (define variables (exported-variables s))
  (define parameters (exported-parameters s))
  (define names (identifiers (append variables parameters) reserved))
  (define-values (lines outputs) (program->code p C names (no-function who s "C")))
  (define stores
    (for/list ([text (in-list outputs)] [k (in-naturals)]) (format "~a[~a] = ~a;" output k text)))
  (define body (append lines stores))
  (define inputs (take-inputs names (length variables) (program-uses p)))
  (string-append
   (format "\nvoid ~a_~a(const double *y, const double *p, double *~a)\n{\n"
           (exported-name s) suffix output)
   (indented (append inputs body (unused inputs)))
   "}\n"))

;; The inputs that are used, by name; n : how many are variables
(define (take-inputs names n uses)
  (for/list ([name (in-list names)] [k (in-naturals)] [count (in-vector uses)] #:when (> count 0))
    (define-values (from index) (if (< k n) (values "y" k) (values "p" (- k n))))
    (format "const double ~a = ~a[~a];" name from index)))

;; Compilers warn of arguments that are not looked at.
(define (unused inputs)
  (for/list ([argument (in-list '("y" "p"))]
             #:unless (for/or ([line (in-list inputs)])
                        (regexp-match? (format " ~a\\[" argument) line)))
    (format "(void) ~a;" argument)))

(define-column names-in-C
  [sqrt "sqrt"] [exp "exp"] [log "log"] [expt "pow"] [abs "fabs"] [sgn "sgn"] [erf "erf"]
  [sin "sin"] [cos "cos"] [tan "tan"] [asin "asin"] [acos "acos"] [atan "atan"] [atan2 "atan2"]
  [sinh "sinh"] [cosh "cosh"] [tanh "tanh"] [asinh "asinh"] [acosh "acosh"] [atanh "atanh"])

(define C
  (language
   (hash-set* names-in-C 'wrapped "wrapped" 'larger "greater")
   (lambda (name rows right symmetric?)
     (define n (length right))
     (append
      (list (format "double ~a_matrix[~a], ~a[~a];" name (* n n) name n))
      (for*/list ([(row i) (in-parallel rows (in-naturals))]
                  [(x j) (in-parallel row (in-naturals))])
        (format "~a_matrix[~a] = ~a;" name (+ (* i n) j) x))
      (for/list ([x (in-list right)] [i (in-naturals)]) (format "~a[~a] = ~a;" name i x))
      (list (format "~a(~a, ~a_matrix, ~a);"
                    (if symmetric? "solve_symmetric" "solve") n name name))))
   (lambda (name k) (format "~a[~a]" name k))
   (lambda (name text) (format "const double ~a = ~a;" name text))))

;; Words of C, its mathematics and the code around.
(define reserved
  (append
   C-keywords
   '("y" "p" "dy" "J" "solve" "solve_symmetric" "wrapped" "sgn")
   (string-split
    (string-append
     "acos asin atan atan2 cos sin tan acosh asinh atanh cosh sinh tanh exp log sqrt pow fabs floor "
     "gamma lgamma tgamma j0 j1 jn y0 y1 yn erf erfc cbrt ceil exp2 expm1 fdim fma fmax fmin fmod "
     "frexp hypot ilogb ldexp log10 log1p log2 logb lround modf nan nearbyint remainder rint round "
     "signbit trunc signgam INFINITY NAN main"))))
